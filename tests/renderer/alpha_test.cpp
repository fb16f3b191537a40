// SPDX-License-Identifier: MIT
// Surfaces that are there in part: what is met and what shines through, for paths and for light.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian {
namespace {

using namespace scenes;
using namespace textures;

class Alpha : public RendererTest {
 protected:
  Image frontal(const Scene& scene, std::uint64_t samples) {
    return render(scene, lookAt({0, 0, 10}, {0, 0, 0}, 2.0 * std::atan(0.09)), {16, 16}, samples);
  }
};

Material veil(float opacity, Material base) {
  base.opacity = opacity;
  base.alphaMode = AlphaMode::blend;
  return base;
}

TEST_F(Alpha, each_of_many_veils_lets_its_share_through_and_costs_no_bounce) {
  for (const int layers : {1, 4, 12}) {
    Scene scene = plainScene(0);
    const Id black = add(scene, veil(0.2f, lambert(glm::vec3(0.0f))));
    for (int i = 0; i < layers; ++i) add(scene, at({0, 0, 0.1 * i}), shape(picture()), black);
    add(scene, at({0, 0, -1}, {1, 0, 0}, 0.0, dvec3(2.0)), shape(picture()), emitter(1.0f));
    expectMean(meanOf(frontal(scene, 256)), std::pow(0.8, layers), 0.003);
  }
}

TEST_F(Alpha, layers_behind_more_veils_than_a_driver_follows_are_counted_as_faults) {
  for (const int layers : {12, 1000}) {
    Scene scene = plainScene(0);
    const Id black = add(scene, veil(0.0005f, lambert(glm::vec3(0.0f))));
    for (int i = 0; i < layers; ++i)
      add(scene, at({0, 0, -0.004 * i}, {1, 0, 0}, 0.0, dvec3(2.0)), shape(picture()), black);
    add(scene, at({0, 0, -6}, {1, 0, 0}, 0.0, dvec3(3.0)), shape(picture()), lambert(glm::vec3(1.0f)));
    renderer().setScene(scene, lookAt({0, 0, 10}, {0, 0, 0}, 2.0 * std::atan(0.09)), {16, 16});
    const AovLayer albedo = renderer().aovs({{Aov::albedo}, 32}).at(0);
    const bool right = std::abs(meanOf(albedo.pixels).value - std::pow(0.9995, layers)) < 0.02;
    EXPECT_TRUE(right || renderer().stats().faults > 0) << layers;
    if (layers == 12) EXPECT_TRUE(right && renderer().stats().faults == 0);
  }
  frontal(plainScene(0), 1);  // what follows finds a clean film
}

TEST_F(Alpha, veils_at_one_place_count_each_whether_of_one_mesh_or_of_several) {
  for (const int copies : {1, 3}) {
    Mesh mesh = picture();
    const auto once = mesh.triangles;
    for (int i = 1; i < copies; ++i) mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
    Scene scene = plainScene(0);
    const Id black = add(scene, veil(0.2f, lambert(glm::vec3(0.0f))));
    for (int i = 0; i < 4; ++i) add(scene, at({0, 0, 0}), shape(mesh), black);
    add(scene, at({0, 0, -1}, {1, 0, 0}, 0.0, dvec3(2.0)), shape(picture()), emitter(1.0f));
    expectMean(meanOf(frontal(scene, 256)), std::pow(0.8, 4 * copies), 0.003);
  }
}

TEST_F(Alpha, a_shadow_ray_finds_what_is_solid_behind_and_before_veils) {
  for (const double solidAt : {0.5, 2.5}) {
    Scene scene = plainScene(0);
    const Id grey = add(scene, veil(0.3f, lambert(glm::vec3(0.0f))));
    add(scene, at({0, 0, 0}), shape(picture()), lambert(glm::vec3(0.8f)));
    const auto beside = [](double along) { return dvec3(4.0 + along, 0.0, 4.0 + along); };
    for (int i = 0; i < 3; ++i)
      add(scene, at(beside(i), {0, 1, 0}, pi / 4, dvec3(3.0)), shape(picture()), grey);
    addLight(scene, {{0, 0, 0}, facing({-1, 0, -1}), dvec3(1.0)}, DirectionalLight{}, 1.0f);
    expectMean(meanOf(frontal(scene, 256)), 0.343 * 0.8 / pi * std::sqrt(0.5), 0.003);
    add(scene, at(beside(solidAt), {0, 1, 0}, pi / 4, dvec3(3.0)), shape(picture()),
        lambert(glm::vec3(0.0f)));
    EXPECT_EQ(meanOf(frontal(scene, 16)).value, 0.0) << "solid at " << solidAt;
  }
}

TEST_F(Alpha, light_comes_through_a_veil_in_proportion) {
  Scene scene = plainScene(0);
  const Id grey = add(scene, veil(0.35f, lambert(glm::vec3(0.0f))));
  add(scene, at({0, 0, 0}), shape(picture()), lambert(glm::vec3(0.8f)));
  // Beside the camera's view, in the light's way.
  add(scene, at({6, 0, 6}, {0, 1, 0}, pi / 4, dvec3(3.0)), shape(picture()), grey);
  addLight(scene, {{0, 0, 0}, facing({-1, 0, -1}), dvec3(1.0)}, DirectionalLight{}, 1.0f);
  expectMean(meanOf(frontal(scene, 256)), 0.65 * 0.8 / pi * std::sqrt(0.5), 0.003);
}

TEST_F(Alpha, opacity_is_the_product_of_factor_texture_and_vertex_colour) {
  Mesh mesh = picture();
  mesh.colors.assign(4, {1.0f, 1.0f, 1.0f, 0.5f});
  Scene scene = plainScene(0);
  Material m = veil(0.8f, emitter(1.0f));
  m.albedoTexture = uniform({1.0f, 1.0f, 1.0f, 0.5f});
  add(scene, at({0, 0, 0}), shape(mesh), m);
  expectMean(meanOf(frontal(scene, 256)), 0.2, 0.003);
}

TEST_F(Alpha, a_mask_is_all_or_nothing_at_its_cutoff) {
  const auto ramp =
      made(16, 1, Format::rgba8, [](int x, int) { return glm::vec4(1.0f, 1.0f, 1.0f, float(x) / 15.0f); });
  Scene scene = plainScene(0);
  Material m = emitter(1.0f);
  m.albedoTexture = slot(ramp);
  m.alphaMode = AlphaMode::mask;
  m.alphaCutoff = 7.5f / 15.0f;
  add(scene, at({0, 0, 0}), shape(picture()), m);
  const Image seen = render(scene, lookAt({0, 0, 10}, {0, 0, 0}, 2.0 * std::atan(0.1)), {16, 16}, 4);
  for (std::size_t i = 0; i < seen.pixels.size(); ++i)
    EXPECT_EQ(seen.pixels[i], i / 3 % 16 < 8 ? 0.0f : 1.0f);
  renderer().setScene(scene, lookAt({0, 0, 10}, {0, 0, 0}, 2.0 * std::atan(0.1)), {16, 16});
  EXPECT_FALSE(renderer().pick(3, 8));
  EXPECT_TRUE(renderer().pick(12, 8));
}

TEST_F(Alpha, white_veils_in_a_white_furnace_cannot_be_seen) {
  Scene scene = plainScene(24);
  const Id white = add(scene, veil(0.5f, lambert(glm::vec3(1.0f))));
  for (int i = 0; i < 4; ++i) add(scene, at({0, 0, 0.3 * i}, {0, 1, 0}, 0.2 * i), shape(picture()), white);
  addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
  expectMean(meanOf(frontal(scene, 256)), 1.0, 0.003);
}

TEST_F(Alpha, an_opaque_material_ignores_its_opacity) {
  Scene scene = plainScene(0);
  Material m = emitter(1.0f);
  m.opacity = 0.1f;
  add(scene, at({0, 0, 0}), shape(picture()), m);
  EXPECT_EQ(meanOf(frontal(scene, 4)).value, 1.0);
}

TEST_F(Alpha, a_thin_walled_mesh_passes_light_without_bending_it) {
  Scene scene = plainScene(8);
  Material pane;
  pane.albedo = glm::vec3(1.0f);
  pane.roughness = 0.0f;
  pane.transmission = 1.0f;
  pane.thinWalled = true;
  add(scene, at({0, 0, 0}), shape(smoothBall(2)), pane);
  Scene empty = plainScene(8);
  for (Scene* s : {&scene, &empty})
    add(*s, at({0, 0, -4}, {0, 1, 0}, 0.0, {6, 6, 1}), Rect{{1, 1}}, emitter(1.0f));
  addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
  expectMean(meanOf(frontal(scene, 256)), 1.0, 0.003);
}

}  // namespace
}  // namespace steradian
