// SPDX-License-Identifier: MIT
// Glowing boxes, cylinders, ellipsoids and disks as lights: strategies that agree, closed forms from inside
// and outside, and less noise than paths alone.
#include <iostream>

#include "tests/renderer/lights_fixture.hpp"

namespace steradian {
namespace {

const CameraView bodyView = lookAt({0, 1.5, 3}, {0, 0.2, -0.2}, 0.8);

struct Body {
  const char* name;
  Shape shape;
  Transform place;
};

/// Turned, stretched, mirrored, in the ground and above it.
std::vector<Body> bodies() {
  return {{"box", Box{{0.4, 0.2, 0.3}}, at({0.2, 0.5, -0.3}, {1, 1, 0}, 0.8, {1, -2, 1})},
          {"sunk box", Box{{0.4, 0.4, 0.4}}, at({-0.2, 0.1, -0.3}, {0, 1, 0}, 0.4)},
          {"cylinder", Cylinder{0.1, 0.8}, at({0.2, 0.4, -0.3}, {1, 0.2, 0}, 1.2, {1, 1, 1.5})},
          {"standing tube", Cylinder{0.03, 1.2}, at({-0.3, 0.6, 0.1})},
          {"ellipsoid", Sphere{0.2}, at({0.2, 0.5, -0.3}, {1, 1, 0}, 0.8, {1, 0.4, -1.6})},
          {"disk", Disk{0.3}, at({0.1, 0.3, -0.4}, {1, 0, 0.3}, 0.9, {1, 1, 0.6})}};
}

class BodyLights : public LightsTest {};

TEST_F(BodyLights, row32_samples_alone_paths_alone_and_both_agree) {
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    Scene scene = ground(plastic(0.4f, glm::vec3(0.7f)), 3);
    add(scene, body.place, body.shape, emitter(5.0f, glm::vec3(0.3f)));
    add(scene, at({-0.6, 0.3, 0.2}), Sphere{0.3}, lambert(glm::vec3(0.6f)));
    expectStrategiesAgree(scene, bodyView, 1024);
  }
}

TEST_F(BodyLights, row32_they_agree_among_many_lights) {
  Scene scene = ground(lambert(glm::vec3(0.7f)), 2);
  for (const Body& body : bodies()) {
    add(scene, body.place, body.shape, emitter(2.0f));
    addLight(scene, at(body.place.translation + dvec3(0.5, 0.6, 0.3)), PointLight{}, 0.2f);
  }
  scene.render.lightSamples = 2;
  expectStrategiesAgree(scene, bodyView, 1024);
}

TEST_F(BodyLights, row33_a_camera_inside_sees_an_even_enclosure) {
  const Shape shells[] = {Box{{2, 1.4, 1}}, Cylinder{1.0, 1.5}, Sphere{1.0}};
  for (const Shape& shell : shells)
    for (const bool stretched : {false, true}) {
      SCOPED_TRACE(testing::Message() << "kind " << shell.index() << (stretched ? " stretched" : ""));
      Scene scene = plainScene(24);
      add(scene, at({0, 0, 0}, {1, 2, 3}, 0.5, stretched ? dvec3(1, 0.6, -1.7) : dvec3(1.0)), shell,
          emitter(1.0f, glm::vec3(0.5f)));
      ablate({});
      expectMean(meanOf(render(scene, lookAt({0.1, 0.1, 0.1}, {0.3, -0.2, -1}, 2.0), {16, 16}, 64)), 2.0,
                 0.003);
    }
}

// A black ball of half the radius hides a quarter of what the wall sees: 1 / (1 - albedo (1 - 1/4)).
TEST_F(BodyLights, row33_what_lies_in_a_glowing_shell_shadows_its_wall) {
  for (const double stretch : {1.0, 1.001}) {
    Scene scene = plainScene(32);
    add(scene, at({0, 0, 0}, {0, 1, 0}, 0.0, {1, 1, stretch}), Sphere{1.0}, emitter(1.0f, glm::vec3(0.8f)));
    add(scene, at({0, 0, 0}), Sphere{0.5}, lambert(glm::vec3(0.0f)));
    ablate({});
    expectMean(meanOf(render(scene, lookAt({0.75, 0, 0}, {1, 0.2, 0.1}, 0.3), {16, 16}, 256)), 2.5, 0.004);
  }
}

TEST_F(BodyLights, row32_they_agree_on_rough_glass_that_glows) {
  Material glowing = emitter(1.0f);
  glowing.albedo = glm::vec3(1.0f);
  glowing.transmission = 1.0f;
  glowing.roughness = 0.9f;
  for (const Body& body : {Body{"sphere", Sphere{0.4}, at({0, 0, 0})},
                           Body{"ellipsoid", Sphere{0.4}, at({0, 0, 0}, {1, 1, 0}, 0.8, {1, 0.7, -1.2})},
                           Body{"box", Box{{0.4, 0.3, 0.4}}, at({0, 0, 0}, {1, 1, 0}, 0.8)},
                           Body{"cylinder", Cylinder{0.3, 0.8}, at({0, 0, 0}, {1, 0.2, 0}, 1.2)}}) {
    SCOPED_TRACE(body.name);
    Scene scene = plainScene(3);
    add(scene, body.place, body.shape, glowing);
    expectStrategiesAgree(scene, lookAt({0, 1.5, 3}, {0, 0, 0}, 0.1), 1024);
  }
}

TEST_F(BodyLights, no_convex_body_lights_itself_from_outside) {
  for (const Body& body : bodies()) {
    Scene scene = plainScene(4);
    add(scene, body.place, body.shape, emitter(1.0f, glm::vec3(0.8f)));
    const dvec3 c = body.place.translation;
    ablate({});
    const Image seen = render(scene, lookAt(c + dvec3(0.7, 1.6, 2.0), c, 0.02), {16, 16}, 64);
    for (const float value : seen.pixels) ASSERT_FLOAT_EQ(value, 1.0f) << body.name;
  }
}

TEST_F(BodyLights, they_light_with_far_less_noise_than_paths_find) {
  const Body bulbs[] = {{"box", Box{dvec3(0.05)}, at({0.2, 2.2, -0.3}, {1, 1, 0}, 0.8)},
                        {"cylinder", Cylinder{0.02, 0.1}, at({0.2, 2.2, -0.3}, {1, 1, 0}, 0.8)},
                        {"ellipsoid", Sphere{0.03}, at({0.2, 2.2, -0.3}, {1, 1, 0}, 0.8, {1, 0.5, 1})}};
  for (const Body& bulb : bulbs) {
    Scene scene = ground(lambert(glm::vec3(0.7f)), 1);
    add(scene, bulb.place, bulb.shape, emitter(60.0f));
    ablate({});
    const Image truth = render(scene, bodyView, {16, 16}, 4096);
    const double sampled = mrse(render(scene, bodyView, {16, 16}, 64), truth);
    Ablation paths;
    paths.lightSampling = false;
    ablate(paths);
    const double met = mrse(render(scene, bodyView, {16, 16}, 64), truth);
    std::cout << bulb.name << ": relative squared error, paths alone / sampled: " << met / sampled << "\n";
    EXPECT_GT(met, 20.0 * sampled) << bulb.name;
  }
}

TEST_F(BodyLights, row41_the_special_pipeline_gives_the_generic_ones_picture) {
  Scene scene = ground(plastic(0.4f, glm::vec3(0.7f)), 3);
  for (const Body& body : bodies()) add(scene, body.place, body.shape, emitter(2.0f));
  Image pictures[2];
  for (const bool special : {false, true}) {
    renderer().setAblation({});
    renderer().allowSpecialization(special);
    renderer().setScene(scene, bodyView, {16, 16});
    if (special) renderer().waitForSpecialization();
    pictures[special] = render(scene, bodyView, {16, 16}, 64);
  }
  expectSamePicture(pictures[1], pictures[0]);
}

}  // namespace
}  // namespace steradian
