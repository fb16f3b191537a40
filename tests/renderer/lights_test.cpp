// SPDX-License-Identifier: MIT
// Lights of non-zero size and many lights, through the whole path tracer: closed forms, and strategies that
// agree.
#include <iostream>

#include "tests/renderer/lights_fixture.hpp"

namespace steradian {
namespace {

TEST_F(LightsTest, row34_a_rect_light_gives_its_form_factor) {
  Scene scene = ground();
  addLight(scene, shining({0, 1, 0}, {0, -1, 0}), RectLight{{1, 1}}, 3.0f);
  expectMean(irradiance(scene, {0, 0, 0}, 256), 3 * 0.7522746885, 0.002);
}

TEST_F(LightsTest, row34_a_disk_light_gives_its_form_factor_scaled_or_not) {
  Scene scene = ground();
  addLight(scene, shining({0, 1.3, 0}, {0, -1, 0}), DiskLight{0.7}, 2.0f);
  expectMean(irradiance(scene, {0, 0, 0}, 256), 2 * pi * 0.49 / (0.49 + 1.69), 0.002);
  Scene scaled = ground();
  addLight(scaled, shining({0, 1.3, 0}, {0, -1, 0}, dvec3(0.5)), DiskLight{1.4}, 2.0f);
  expectMean(irradiance(scaled, {0, 0, 0}, 256), 2 * pi * 0.49 / (0.49 + 1.69), 0.002);
}

TEST_F(LightsTest, row28_a_sphere_light_follows_the_square_law_near_and_far) {
  for (const double distance : {1.001, 2.0, 100.0, 1e4}) {
    SCOPED_TRACE(distance);
    Scene scene = ground();
    addLight(scene, at({0, distance, 0}), SphereLight{1.0}, 5.0f);
    expectMean(irradiance(scene, {0, 0, 0}, 256), 5 * pi / (distance * distance), 0.002);
  }
  Scene aside = ground();
  addLight(aside, at({3, 4, 0}), SphereLight{0.5}, 5.0f);
  expectMean(irradiance(aside, {0, 0, 0}, 256), 5 * pi * 0.25 / 25.0 * 0.8, 0.002);
}

TEST_F(LightsTest, emissive_shapes_light_as_area_lights_do_but_to_both_sides) {
  Scene below = ground();
  add(below, at({0, 1, 0}, {1, 0, 0}, pi), Rect{{1, 1}}, emitter(1.0f));  // its +Y side is down
  expectMean(irradiance(below, {0, 0, 0}, 256), 0.7522746885, 0.002);
  Scene above = ground();
  add(above, at({0, 1, 0}), Rect{{1, 1}}, emitter(1.0f));
  expectMean(irradiance(above, {0, 0, 0}, 256), 0.7522746885, 0.002);
  // Mirrored and sheared axes: two triangles' worth of the same rect.
  Scene mirrored = ground();
  add(mirrored, at({0, 1, 0}, {0, 1, 0}, 0.4, {-2, 1, 0.5}), Rect{{0.5, 2}}, emitter(1.0f));
  expectMean(irradiance(mirrored, {0, 0, 0}, 256), 0.7522746885, 0.002);
}

TEST_F(LightsTest, flat_lights_are_dark_behind) {
  const std::variant<RectLight, DiskLight> kinds[] = {RectLight{{1, 1}}, DiskLight{0.5}};
  for (const auto& kind : kinds) {
    Scene scene = ground();
    std::visit([&](const auto& k) { addLight(scene, shining({0, 1, 0}, {0, 1, 0}), k, 1.0f); }, kind);
    EXPECT_EQ(irradiance(scene, {0.2, 0, 0}, 16).value, 0.0);
    const Image front = render(scene, lookAt({0, 3, 0.1}, {0, 1, 0}, 0.05), {8, 8}, 4);
    EXPECT_EQ(meanOf(front).value, 1.0) << "seen by the camera";
    const Image back = render(scene, lookAt({0, 0.5, 0.01}, {0, 1, 0}, 0.05), {8, 8}, 4);
    EXPECT_EQ(meanOf(back).value, 0.0);
  }
}

TEST_F(LightsTest, a_sphere_light_is_seen_as_bright_as_it_says) {
  Scene scene = plainScene(2);
  addLight(scene, at({0, 0, 0}), SphereLight{1.0}, 7.0f, {1.0f, 0.5f, 0.25f});
  const Image image = render(scene, lookAt({0, 0, 5}, {0, 0, 0}, 0.1), {8, 8}, 4);
  EXPECT_FLOAT_EQ(float(meanOf(image, 0).value), 7.0f);
  EXPECT_FLOAT_EQ(float(meanOf(image, 2).value), 1.75f);
}

TEST_F(LightsTest, a_sun_gives_the_illuminance_it_states_whatever_its_size) {
  for (const float diameter : {0.0f, 0.0093f, 0.1f, 1.0f}) {
    SCOPED_TRACE(diameter);
    Scene scene = ground();
    addLight(scene, shining({0, 0, 0}, {0, -1, 0}), DirectionalLight{diameter}, 1000.0f);
    expectMean(irradiance(scene, {0, 0, 0}, 256), 1000.0, 0.001);
    Scene slanting = ground();  // the mean of a disc's directions is its axis
    addLight(slanting, shining({0, 0, 0}, {3, -4, 0}), DirectionalLight{diameter}, 1000.0f);
    const double half = 0.5 * diameter, whole = 800.0;
    ASSERT_LT(half, std::asin(0.8));
    expectMean(irradiance(slanting, {0, 0, 0}, 256), whole, 0.001);
  }
}

TEST_F(LightsTest, the_sun_is_a_disc_in_the_sky) {
  Scene scene = ground();
  const dvec3 towards = glm::normalize(dvec3(1, 2, -3));
  addLight(scene, shining({0, 0, 0}, -towards), DirectionalLight{0.0093f}, 100.0f);
  const double radiance = 100.0 / (pi * std::pow(std::sin(0.00465), 2));
  const dvec3 eye(0, 1, 0);
  const Image inside = render(scene, lookAt(eye, eye + towards, 0.004), {8, 8}, 4);
  EXPECT_NEAR(meanOf(inside).value, radiance, 1e-5 * radiance);
  // A picture twice as wide as the disc: its round area of it.
  const Image whole = render(scene, lookAt(eye, eye + towards, 0.0186), {64, 64}, 64);
  EXPECT_NEAR(meanOf(whole).value, radiance * pi / 16.0, 3e-3 * radiance);
}

/// A floor that is lit by one light of each kind, some of them in the mirror's way.
Scene everyLight(const Material& floor) {
  Scene scene = ground(floor, 3);
  addLight(scene, shining({-1, 1.2, 0}, {0.3, -1, 0}), RectLight{{0.8, 0.4}}, 4.0f);
  addLight(scene, shining({1, 0.8, -0.5}, {-0.2, -1, 0.3}), DiskLight{0.3}, 6.0f);
  addLight(scene, at({0.1, 0.5, -1}), SphereLight{0.25}, 5.0f);
  addLight(scene, at({0, 2, 1}), PointLight{}, 1.0f);
  addLight(scene, shining({0, 0, 0}, {0.5, -1, 0.2}), DirectionalLight{0.2f}, 1.0f);
  add(scene, at({0.5, 0.3, 0.2}), Sphere{0.3}, plastic(0.3f, glm::vec3(0.6f)));
  return scene;
}

TEST_F(LightsTest, row32_light_sampling_paths_alone_and_both_agree) {
  for (const Material& floor : {lambert(glm::vec3(0.7f)), metal(0.4f)}) {
    SCOPED_TRACE(floor.metallic);
    expectStrategiesAgree(everyLight(floor), lookAt({0, 1.5, 3}, {0, 0.2, -0.2}, 0.8), 1024);
  }
}

TEST_F(LightsTest, row41_the_special_pipeline_sees_the_same_lights) {
  const CameraView view = lookAt({0, 1.5, 3}, {0, 0.2, -0.2}, 0.8);
  Scene few = everyLight(plastic(0.3f, glm::vec3(0.5f)));
  for (const int lightSamples : {8, 2}) {  // all lights, or some by the tree
    SCOPED_TRACE(lightSamples);
    few.render.lightSamples = lightSamples;
    renderer().allowSpecialization(false);
    const Image generic = render(few, view, {16, 16}, 32);
    renderer().allowSpecialization(true);
    renderer().setScene(few, view, {16, 16});
    renderer().waitForSpecialization();
    const Image special = render(few, view, {16, 16}, 32, 0);
    EXPECT_TRUE(renderer().stats().variant.specialized);
    expectSamePicture(special, generic);
  }
}

/// Lamps over a floor, and the irradiance that they give it at the origin.
struct Lamps {
  Scene scene = ground();
  double expected = 0.0;
};
Lamps lamps(int count, bool spheres) {
  Lamps made;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.4 * i, r = 0.6 * std::sqrt(i + 1.0), radius = 0.05 + 0.01 * (i % 4);
    const dvec3 p(r * std::cos(angle), 0.7 + 0.1 * (i % 7), r * std::sin(angle));
    const float power = float(1 + i % 5);
    const double intensity = spheres ? double(power) * pi * radius * radius : double(power);
    if (spheres) {
      addLight(made.scene, at(p), SphereLight{radius}, power);
    } else {
      addLight(made.scene, at(p), PointLight{}, power);
    }
    made.expected += intensity * p.y / std::pow(glm::dot(p, p), 1.5);
  }
  return made;
}

TEST_F(LightsTest, many_lights_chosen_by_the_tree_stay_unbiased_with_less_noise_than_uniform_choice) {
  Ablation uniform;
  uniform.lightTree = false;
  for (const bool spheres : {false, true}) {
    SCOPED_TRACE(spheres);
    Lamps many = lamps(spheres ? 60 : 300, spheres);
    many.scene.render.lightSamples = 2;
    const Mean byTree = irradiance(many.scene, {0, 0, 0}, 256);
    EXPECT_NEAR(byTree.value, many.expected, 3.0 * byTree.sigma);
    EXPECT_LT(byTree.sigma, 0.01 * many.expected);
    ablate(uniform);
    const Mean uniformly = irradiance(many.scene, {0, 0, 0}, 256);
    ablate({});
    EXPECT_NEAR(uniformly.value, many.expected, 3.0 * uniformly.sigma);
    EXPECT_LT(byTree.sigma, 0.7 * uniformly.sigma);
    std::cout << "standard error of uniform choice / of the tree: " << uniformly.sigma / byTree.sigma << "\n";
  }
}

TEST_F(LightsTest, suns_and_lamps_share_the_samples_of_a_tree) {
  Lamps many = lamps(40, true);
  addLight(many.scene, shining({0, 0, 0}, {0, -1, 0}), DirectionalLight{0.05f}, 3.0f);
  addLight(many.scene, shining({0, 0, 0}, {3, -4, 0}), DirectionalLight{}, 1.0f);
  many.scene.render.lightSamples = 1;
  const Mean measured = irradiance(many.scene, {0, 0, 0}, 512);
  EXPECT_NEAR(measured.value, many.expected + 3.0 + 0.8, 3.0 * measured.sigma);
  EXPECT_LT(measured.sigma, 0.01 * measured.value);
}

}  // namespace
}  // namespace steradian
