// SPDX-License-Identifier: MIT
// Glowing meshes as lights: closed forms, strategies that agree, and less noise than paths alone.
#include <iostream>

#include "tests/renderer/lights_fixture.hpp"
#include "tests/renderer/meshes.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian {
namespace {

const CameraView overview = lookAt({0, 1.5, 3}, {0, 0.2, -0.2}, 0.8);

/// A stretched, turned and mirrored ball of triangles of very different sizes.
void addLantern(Scene& scene, const dvec3& place, double size, const Material& material) {
  Mesh ball = meshes::icosphere(1);
  for (glm::vec3& p : ball.positions) p.x = p.x > 0.0f ? p.x * p.x : p.x;
  add(scene, at(place, {1, 1, 0}, 0.8, dvec3(size, -2.0 * size, 0.5 * size)), textures::shape(ball),
      material);
}

class MeshLights : public LightsTest {};

TEST_F(MeshLights, row34_a_glowing_square_of_two_triangles_gives_the_form_factor_stretched_or_not) {
  for (const auto& [half, scale] : {std::pair(0.5f, dvec3(1.0)), std::pair(0.25f, dvec3(2.0, -1.0, -2.0))}) {
    Scene scene = ground();
    add(scene, at({0, 1, 0}, {0, 1, 0}, 0.0, scale), textures::shape(meshes::quad(half)), emitter(3.0f));
    expectMean(irradiance(scene, {0, 0, 0}, 256), 3 * 0.7522746885, 0.002);
  }
}

TEST_F(MeshLights, row32_samples_alone_paths_alone_and_both_agree) {
  Scene scene = ground(plastic(0.4f, glm::vec3(0.7f)), 3);
  addLantern(scene, {0.2, 0.7, -0.3}, 0.2, emitter(5.0f));
  add(scene, at({-0.6, 0.3, 0.2}), Sphere{0.3}, lambert(glm::vec3(0.6f)));
  expectStrategiesAgree(scene, overview, 1024);
}

// The larger the triangle that is lit, the farther from it rays start, and the nearer they came to the lamp's
// own facet.
TEST_F(MeshLights, row32_they_agree_on_a_large_ground_that_is_a_mesh) {
  for (const double height : {0.3, 1.0, 2.0}) {
    SCOPED_TRACE(height);
    Scene scene = plainScene(1);
    add(scene, at({0, 0, 0}), textures::shape(meshes::quad(30.0f)), lambert(glm::vec3(0.8f)));
    addLantern(scene, {0.1, height, -0.3}, 0.05 + 0.2 * height, emitter(5.0f));
    expectStrategiesAgree(scene, overview, 2048);
  }
}

TEST_F(MeshLights, row32_they_agree_on_a_texture_that_glows_in_parts) {
  Material screen = emitter(8.0f);
  screen.emissionTexture = textures::slot(textures::made(4, 4, textures::Format::rgbaHalf, [](int x, int y) {
    return glm::vec4(x == 1 ? 1.0f : 0.0f, y == 2 ? 1.0f : 0.25f, 0.1f, 1.0f);
  }));
  Scene scene = ground(lambert(glm::vec3(0.7f)), 2);
  add(scene, at({0, 0.6, -0.6}, {1, 0, 0}, 0.3, dvec3(0.5)), textures::shape(textures::picture()), screen);
  expectStrategiesAgree(scene, overview, 1024);
}

TEST_F(MeshLights, row32_they_agree_on_a_screen_with_holes_and_veils) {
  for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend}) {
    SCOPED_TRACE(mode == AlphaMode::mask ? "mask" : "blend");
    Material screen = emitter(8.0f);
    screen.alphaMode = mode;
    screen.albedoTexture = textures::slot(textures::made(4, 4, textures::Format::rgbaHalf, [](int x, int y) {
      return glm::vec4(1.0f, 1.0f, 1.0f, float((x + 2 * y) % 4) / 3.0f);
    }));
    Scene scene = ground(lambert(glm::vec3(0.7f)), 2);
    add(scene, at({0, 0.6, -0.6}, {1, 0, 0}, 0.3, dvec3(0.5)), textures::shape(textures::picture()), screen);
    expectStrategiesAgree(scene, overview, 1024);
  }
}

TEST_F(MeshLights, row32_they_agree_among_many_lights) {
  Scene scene = ground(lambert(glm::vec3(0.7f)), 2);
  for (int i = 0; i < 6; ++i) {
    const double angle = 1.1 * i;
    addLantern(scene, {std::cos(angle), 0.3 + 0.1 * i, std::sin(angle) - 0.5}, 0.1, emitter(2.0f + float(i)));
    addLight(scene, at({0.5 * std::sin(angle), 1.0, 0.2 * i - 0.8}), PointLight{}, 0.2f);
  }
  scene.render.lightSamples = 2;
  expectStrategiesAgree(scene, overview, 1024);
}

TEST_F(MeshLights, a_small_glowing_mesh_lights_with_far_less_noise_than_paths_find) {
  Scene scene = ground(lambert(glm::vec3(0.7f)), 1);
  addLantern(scene, {0.2, 0.9, -0.3}, 0.05, emitter(60.0f));
  ablate({});
  const Image truth = render(scene, overview, {16, 16}, 4096);
  const double sampled = mrse(render(scene, overview, {16, 16}, 64), truth);
  Ablation paths;
  paths.lightSampling = false;
  ablate(paths);
  const double met = mrse(render(scene, overview, {16, 16}, 64), truth);
  std::cout << "relative squared error, paths alone / sampled: " << met / sampled << "\n";
  EXPECT_GT(met, 20.0 * sampled);
}

TEST_F(MeshLights, row41_the_special_pipeline_gives_the_generic_ones_picture) {
  Scene scene = ground(plastic(0.4f, glm::vec3(0.7f)), 3);
  addLantern(scene, {0.2, 0.7, -0.3}, 0.2, emitter(5.0f));
  Image pictures[2];
  for (const bool special : {false, true}) {
    renderer().allowSpecialization(special);
    renderer().setScene(scene, overview, {16, 16});
    if (special) renderer().waitForSpecialization();
    pictures[special] = render(scene, overview, {16, 16}, 16);
  }
  expectSamePicture(pictures[1], pictures[0]);
}

}  // namespace
}  // namespace steradian
