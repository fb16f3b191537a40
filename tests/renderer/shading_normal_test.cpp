// SPDX-License-Identifier: MIT
// Normals that are not those of the facets: no black fringes, no leaks, no energy from nowhere.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian {
namespace {

using namespace scenes;
using namespace textures;

class ShadingNormals : public RendererTest {};

// Pixels within a circle around the middle of a picture from -1 to 1.
struct Covered {
  double least = 1e9, most = 0.0, mean = 0.0;
};
Covered covered(const Image& image, double within) {
  Covered c;
  int pixels = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double u = (2.0 * x + 1.0) / image.width - 1.0, v = (2.0 * y + 1.0) / image.height - 1.0;
      if (std::hypot(u, v) > within) continue;
      const double value = image.pixels[3 * (std::size_t(y) * image.width + x)];
      c.least = std::min(c.least, value);
      c.most = std::max(c.most, value);
      c.mean += value;
      pixels += 1;
    }
  c.mean /= pixels;
  return c;
}

// Without bent normals: 0 in the darkest pixel, 0.93 on average.
TEST_F(ShadingNormals, row_2_23_even_a_mirror_of_twenty_facets_has_no_black_fringe_in_a_white_furnace) {
  Scene scene = plainScene(16);
  add(scene, at({0, 0, 0}), shape(smoothBall(0)), metal(0.0f));
  addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
  const Image seen = render(scene, lookAt({0, 0, 100}, {0, 0, 0}, 2.0 * std::atan(0.01)), {32, 32}, 16);
  EXPECT_GT(covered(seen, 2.0).least, 0.999);
}

// Without bent normals: 0.896 in the darkest pixel of the ball of roughness 0.1.
TEST_F(ShadingNormals, row_2_23_a_smooth_white_ball_has_no_black_fringe_in_a_white_furnace) {
  for (const Material& m : {metal(0.0f), metal(0.1f), lambert(glm::vec3(1.0f))}) {
    Scene scene = plainScene(16);
    add(scene, at({0, 0, 0}), shape(smoothBall(1)), m);
    addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
    const Image seen = render(scene, lookAt({0, 0, 100}, {0, 0, 0}, 2.0 * std::atan(0.01)), {32, 32}, 256);
    const Covered ball = covered(seen, 0.93);
    EXPECT_GT(ball.least, 0.9) << m.roughness;
    EXPECT_LT(ball.most, 1.1) << m.roughness;
    EXPECT_NEAR(ball.mean, 1.0, 0.01) << m.roughness;
  }
}

// Where the side of the shading normal alone counts: 47 nit.
TEST_F(ShadingNormals, row_2_23_no_light_leaks_through_a_plane_with_a_strong_normal_map) {
  const auto waves = made(16, 16, Format::rgba8, [](int x, int y) {
    return glm::vec4(x % 2 ? 0.95f : 0.05f, y % 2 ? 0.95f : 0.05f, 0.55f, 1.0f);
  });
  for (const float roughness : {0.1f, 1.0f}) {
    Scene scene = plainScene(4);
    Material m = plastic(roughness, glm::vec3(0.8f));
    m.normalTexture = slot(waves, false);
    m.normalScale = 3.0f;
    add(scene, at({0, 0, 0}, {1, 0, 0}, 0.0, dvec3(100.0)), shape(picture()), m);
    // All light is behind, at a low angle.
    addLight(scene, {{0, 0, 0}, facing({1, 0.5, 0.3}), dvec3(1.0)}, DirectionalLight{}, 1000.0f);
    addLight(scene, at({0, -30, -3}), SphereLight{1.0}, 1e5f);
    const Image seen = render(scene, lookAt({0, -8, 3}, {0, 0, 0}, 0.5), {16, 16}, 64);
    EXPECT_EQ(meanOf(seen).value, 0.0) << roughness;
  }
}

TEST_F(ShadingNormals, a_closed_smooth_box_keeps_its_light_inside) {
  Mesh box;
  for (int i = 0; i < 8; ++i) box.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (const glm::vec3& p : box.positions) box.normals.push_back(glm::normalize(p));
  Scene scene = plainScene(6);
  add(scene, at({0, 0, 0}), shape(box), lambert(glm::vec3(0.8f)));
  addLight(scene, at({3, 4, 5}), PointLight{}, 1e4f);
  addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
  EXPECT_EQ(meanOf(render(scene, lookAt({0.2, 0.1, 0.3}, {1, 0.4, -0.5}, 1.2), {16, 16}, 64)).value, 0.0);
}

TEST_F(ShadingNormals, a_smooth_ball_looks_like_the_sphere_where_facets_would_show) {
  const auto picture = [&](Shape shape) {
    Scene scene = plainScene(1);
    add(scene, at({0, 0, 0}), shape, lambert(glm::vec3(0.8f)));
    addLight(scene, {{0, 0, 0}, facing({0, 0, -1}), dvec3(1.0)}, DirectionalLight{}, 1.0f);
    return render(scene, lookAt({0, 0, 100}, {0, 0, 0}, 2.0 * std::atan(0.007)), {16, 16}, 16);
  };
  const Image sphere = picture(Sphere{1.0});
  const double smooth = mrse(picture(shape(smoothBall(2))), sphere);
  const double facets = mrse(picture(shape(meshes::icosphere(2))), sphere);
  EXPECT_LT(smooth, 2e-4);
  EXPECT_GT(facets, 5.0 * smooth);
}

TEST_F(ShadingNormals, rough_and_smooth_glass_balls_keep_as_much_of_a_furnace_as_spheres) {
  for (const float roughness : {0.0f, 0.4f}) {
    const auto share = [&](Shape ball) {
      Scene scene = plainScene(64);
      Material glass;
      glass.albedo = glm::vec3(1.0f);
      glass.roughness = roughness;
      glass.transmission = 1.0f;
      add(scene, at({0, 0, 0}), ball, glass);
      addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
      const Image seen = render(scene, lookAt({0, 0, 100}, {0, 0, 0}, 2.0 * std::atan(0.01)), {16, 16}, 256);
      return covered(seen, 0.93).mean;
    };
    expectMean({share(shape(smoothBall(3))), 0.0}, share(Sphere{1.0}), 0.01);
  }
}

TEST_F(ShadingNormals, are_part_of_what_parts_of_a_picture_are_told_apart_by) {
  const auto fingerprint = [&](float tilt) {
    Mesh ball = smoothBall(2);
    ball.normals[0] = glm::normalize(ball.normals[0] + glm::vec3(tilt, 0.0f, 0.0f));
    Scene scene = plainScene(1);
    add(scene, at({0, 0, 0}), shape(std::move(ball)), lambert(glm::vec3(0.8f)));
    renderer().setScene(scene, lookAt({0, 0, 9}, {0, 0, 0}, 0.5), {8, 8});
    return renderer().sceneFingerprint();
  };
  EXPECT_EQ(fingerprint(0.0f), fingerprint(0.0f));
  EXPECT_NE(fingerprint(0.0f), fingerprint(0.1f));
}

}  // namespace
}  // namespace steradian
