// SPDX-License-Identifier: MIT
// Textures, vertex colours and normal maps of meshes in pictures, against closed forms.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian {
namespace {

using namespace scenes;
using namespace textures;

class Textures : public RendererTest {
 protected:
  /// The picture() quad filling a film of as many pixels, seen from +Z.
  Image frontal(const Scene& scene, Extent film, std::uint64_t samples = 1) {
    return render(scene, lookAt({0, 0, 10}, {0, 0, 0}, 2.0 * std::atan(0.1)), film, samples);
  }
  static glm::vec3 pixel(const Image& image, int x, int y) {
    const float* p = &image.pixels[3 * (std::size_t(y) * image.width + x)];
    return {p[0], p[1], p[2]};
  }
};

Material glowing(TextureSlot slot, float nit = 1.0f) {
  Material m = emitter(nit);
  m.emissionTexture = std::move(slot);
  return m;
}

// Every texel has a colour of its own.
glm::vec4 unlike(int x, int y) {
  return {0.125f + 0.125f * float(x), 0.25f + 0.125f * float(y), x == y ? 0.5f : 0.75f, 1.0f};
}

TEST_F(Textures, an_emission_texture_is_seen_texel_by_texel_with_its_first_one_top_left) {
  Scene scene = plainScene(1);
  add(scene, at({0, 0, 0}), shape(picture()), glowing(slot(made(4, 3, Format::rgbaHalf, unlike)), 2.0f));
  const Image seen = frontal(scene, {8, 8}, 4);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      if (y != 2 && y != 5)  // texels are 8 / 3 pixels high
        EXPECT_LT(glm::distance(pixel(seen, x, y), 2.0f * glm::vec3(unlike(x / 2, y * 3 / 8))), 1e-6f)
            << x << " " << y;
}

TEST_F(Textures, sRGB_codes_of_8_and_16_bits_give_the_radiance_that_the_standard_says) {
  for (const Format format : {Format::rgba8, Format::rgba16}) {
    Scene scene = plainScene(1);
    const auto ramp = made(16, 1, format, [](int x, int) { return glm::vec4(float(x) / 15.0f); });
    add(scene, at({0, 0, 0}), shape(picture()), glowing(slot(ramp)));
    const Image seen = frontal(scene, {16, 16}, 4);
    for (int x = 0; x < 16; ++x) {
      const double code = x / 15.0;
      const double linear = code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
      EXPECT_NEAR(pixel(seen, x, 8).y, linear, 2e-6) << x;
    }
  }
}

TEST_F(Textures, transforms_second_coordinates_and_wrapping_move_the_picture) {
  Mesh mesh = picture();
  mesh.uv1 = mesh.uv0;
  mesh.uv0.assign(4, glm::vec2(0.0f));
  Scene scene = plainScene(1);
  TextureSlot turned = slot(made(2, 2, Format::rgbaHalf, unlike));
  turned.uvSet = 1;
  turned.transformX = {0.0f, 2.0f, 0.0f};  // two repetitions of the transposed picture down
  turned.transformY = {1.0f, 0.0f, 0.5f};
  turned.wrapU = Wrap::mirror;
  add(scene, at({0, 0, 0}), shape(mesh), glowing(turned));
  const Image seen = frontal(scene, {4, 4}, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const int column = y < 2 ? y : 3 - y, row = (x / 2 + 1) % 2;
      EXPECT_LT(glm::distance(pixel(seen, x, y), glm::vec3(unlike(column, row))), 1e-6f) << x << " " << y;
    }
}

TEST_F(Textures, a_texture_far_away_shows_its_mean_at_one_sample) {
  Scene scene = plainScene(1);
  const auto checks = made(64, 64, Format::rgba8, [](int x, int y) { return glm::vec4((x + y) % 2); });
  add(scene, at({0, 0, 0}), shape(picture()), glowing(slot(checks, false)));
  const Image seen = frontal(scene, {8, 8}, 1);  // 8 x 8 texels per pixel: a lookup in full resolution varies
  for (int y = 2; y < 6; ++y)
    for (int x = 2; x < 6; ++x) EXPECT_NEAR(pixel(seen, x, y).x, 0.5f, 0.005f);
}

// Diffuse light of a sun at `direction` (towards it).
double lambertRadiance(double albedo, const dvec3& normal, const dvec3& direction) {
  return albedo / pi * std::max(0.0, glm::dot(normal, glm::normalize(direction)));
}

TEST_F(Textures, albedo_texture_and_vertex_colours_multiply_the_factor) {
  Mesh mesh = picture();
  mesh.colors.assign(4, {0.5f, 1.0f, 0.25f, 1.0f});
  Scene scene = plainScene(0);
  Material m = lambert({0.8f, 0.4f, 0.6f});
  m.albedoTexture = uniform({0.5f, 0.75f, 1.0f, 1.0f});
  add(scene, at({0, 0, 0}), shape(mesh), m);
  addLight(scene, {{0, 0, 0}, facing({0, 0, -1}), dvec3(1.0)}, DirectionalLight{}, 1.0f);
  const glm::vec3 seen = pixel(frontal(scene, {4, 4}, 4), 1, 2);
  EXPECT_LT(glm::distance(seen, glm::vec3(0.8f * 0.25f, 0.4f * 0.75f, 0.6f * 0.25f) / float(pi)), 1e-5f);
}

TEST_F(Textures, a_normal_map_tilts_the_light_to_the_right_and_up_also_where_mirrored) {
  const dvec3 tilted = glm::normalize(dvec3(0.3, 0.2, 0.9));
  const auto shown = [&](Mesh mesh, const dvec3& scale) {
    Scene scene = plainScene(0);
    Material m = lambert(glm::vec3(0.8f));
    m.normalTexture = uniform(glm::vec4(0.5f + 0.5f * glm::vec3(tilted), 1.0f), Format::rgba16);
    add(scene, at({0, 0, 0}, {0, 1, 0}, 0.0, scale), shape(std::move(mesh)), m);
    addLight(scene, {{0, 0, 0}, facing({-1, -2, -3}), dvec3(1.0)}, DirectionalLight{}, 1.0f);
    return double(pixel(frontal(scene, {4, 4}, 4), 1, 2).x);
  };
  const dvec3 sun(1, 2, 3), mirrored(-tilted.x, tilted.y, tilted.z);
  EXPECT_NEAR(shown(picture(), dvec3(1.0)), lambertRadiance(0.8, tilted, sun), 1e-4);
  Mesh withTangents = picture();
  withTangents.normals.assign(4, {0, 0, 1});
  withTangents.tangents.assign(4, {1, 0, 0, 1});
  EXPECT_NEAR(shown(withTangents, dvec3(1.0)), lambertRadiance(0.8, tilted, sun), 1e-4);
  // u runs to the left: in the texture coordinates, in the tangents, or by a mirroring instance.
  Mesh flipped = picture();
  for (glm::vec2& uv : flipped.uv0) uv.x = 1.0f - uv.x;
  EXPECT_NEAR(shown(flipped, dvec3(1.0)), lambertRadiance(0.8, mirrored, sun), 1e-4);
  EXPECT_NEAR(shown(picture(), {-1, 1, 1}), lambertRadiance(0.8, mirrored, sun), 1e-4);
  EXPECT_NEAR(shown(withTangents, {-1, 1, 1}), lambertRadiance(0.8, mirrored, sun), 1e-4);
  withTangents.tangents.assign(4, {-1, 0, 0, -1});
  EXPECT_NEAR(shown(withTangents, dvec3(1.0)), lambertRadiance(0.8, mirrored, sun), 1e-4);
}

TEST_F(Textures, roughness_and_metal_come_from_green_and_blue) {
  Scene scene = plainScene(2);
  Material m = metal(1.0f, {0.9f, 0.6f, 0.3f});
  m.metallicRoughnessTexture = uniform({1.0f, 0.0f, 1.0f, 1.0f});
  add(scene, at({0, 0, 0}), shape(picture()), m);
  addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
  // Roughness 0: a perfect mirror, without the losses of rough metal.
  EXPECT_LT(glm::distance(pixel(frontal(scene, {4, 4}, 16), 1, 1), glm::vec3(0.9f, 0.6f, 0.3f)), 1e-3f);
}

// A GPU may round special pipelines in another way: row 41's gate.
TEST_F(Textures, row41_a_special_pipeline_gives_the_same_picture_bit_by_bit) {
  Scene scene = plainScene(4);
  Material m = plastic(0.6f, glm::vec3(0.9f));
  const auto noise = made(16, 16, Format::rgba8, [](int x, int y) {
    return glm::vec4((x * 7 + y * 13) % 16, (x * 5 + y * 3) % 16, 15, (x * y) % 16) / 15.0f;
  });
  m.albedoTexture = slot(noise, false);
  m.metallicRoughnessTexture = slot(noise, false);
  m.normalTexture = slot(noise, false);
  m.alphaMode = AlphaMode::blend;
  Mesh mesh = picture();
  mesh.colors.assign(4, {0.9f, 0.8f, 1.0f, 0.9f});
  add(scene, at({0, 0, 0}, {1, 0, 0}, -0.7), shape(mesh), m);
  add(scene, at({0, 0.2, 0}, {1, 1, 0}, 0.4, dvec3(0.4)), shape(smoothBall(2)), metal(0.3f));
  addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
  addLight(scene, at({1, 2, 2}), PointLight{}, 10.0f);
  const CameraView view = lookAt({0, 0, 3}, {0, 0, 0}, 0.8);
  const Image generic = render(scene, view, {16, 16}, 16);
  renderer().allowSpecialization(true);
  renderer().setScene(scene, view, {16, 16});
  renderer().waitForSpecialization();
  const Image special = render(scene, view, {16, 16}, 16);
  expectSamePicture(special, generic);
}

TEST_F(Textures, no_texture_counts_on_shapes_that_are_not_meshes) {
  Scene scene = plainScene(0);
  Material m = glowing(uniform({0.5f, 0.5f, 0.5f, 1.0f}));
  m.opacity = 0.3f;
  m.alphaMode = AlphaMode::blend;
  add(scene, at({0, 0, 0}, {1, 0, 0}, pi / 2), Rect{{2, 2}}, m);
  EXPECT_EQ(pixel(frontal(scene, {4, 4}, 4), 1, 1), glm::vec3(1.0f));
}

}  // namespace
}  // namespace steradian
