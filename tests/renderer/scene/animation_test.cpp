// SPDX-License-Identifier: MIT
// Evaluation of keyed animation against closed forms.
#include "renderer/scene/animation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/scene/scene.hpp"

using namespace steradian;

namespace {

/// A scene with one lamp (id 1) and one channel on it.
Scene animated(Property property, Interpolation interpolation, std::vector<Keyframe> keys) {
  Scene scene;
  Object lamp;
  lamp.id = Id(1);
  lamp.content = Light{};
  scene.objects = {lamp};
  scene.nextId = Id(2);
  scene.animation.channels = {{Id(1), property, interpolation, std::move(keys)}};
  return scene;
}
double xAt(const Scene& scene, double time) {
  return evaluatedAt(scene, time).objects[0].transform.translation.x;
}

}  // namespace

TEST(Animation, holds_the_first_and_the_last_key) {
  for (const auto how : {Interpolation::step, Interpolation::linear, Interpolation::cubic}) {
    const Scene scene = animated(Property::translation, how, {{1.0, {3, 0, 0, 0}}, {2.0, {5, 0, 0, 0}}});
    EXPECT_EQ(xAt(scene, -10.0), 3.0);
    EXPECT_EQ(xAt(scene, 1.0), 3.0);
    EXPECT_EQ(xAt(scene, 2.0), 5.0);
    EXPECT_EQ(xAt(scene, 1e9), 5.0);
  }
}

TEST(Animation, step_keeps_the_key_before_and_linear_mixes) {
  const std::vector<Keyframe> keys{{0.0, {1, 0, 0, 0}}, {4.0, {9, 0, 0, 0}}};
  EXPECT_EQ(xAt(animated(Property::translation, Interpolation::step, keys), 3.999), 1.0);
  EXPECT_EQ(xAt(animated(Property::translation, Interpolation::linear, keys), 1.0), 3.0);
}

TEST(Animation, catmull_rom_passes_through_its_keys_and_reproduces_lines_and_inner_parabolas) {
  std::vector<Keyframe> line, parabola;
  for (const double t : {0.0, 1.0, 2.0, 3.0, 4.0}) {
    line.push_back({t, {2 * t + 1, 0, 0, 0}});
    parabola.push_back({t, {t * t, 0, 0, 0}});
  }
  const Scene straight = animated(Property::translation, Interpolation::cubic, line);
  const Scene curved = animated(Property::translation, Interpolation::cubic, parabola);
  for (const double t : {0.0, 0.4, 1.0, 1.5, 2.7, 4.0}) EXPECT_NEAR(xAt(straight, t), 2 * t + 1, 1e-14);
  for (const double t : {1.0, 1.25, 1.5, 2.0, 2.9, 3.0}) EXPECT_NEAR(xAt(curved, t), t * t, 1e-14);
}

TEST(Animation, catmull_rom_is_smooth_over_uneven_keys) {
  const Scene scene =
      animated(Property::translation, Interpolation::cubic,
               {{0.0, {0, 0, 0, 0}}, {1.0, {1, 0, 0, 0}}, {5.0, {-2, 0, 0, 0}}, {6.0, {4, 0, 0, 0}}});
  const double h = 1e-6;
  for (const double t : {1.0, 5.0})
    EXPECT_NEAR((xAt(scene, t) - xAt(scene, t - h)) / h, (xAt(scene, t + h) - xAt(scene, t)) / h, 1e-4);
}

TEST(Animation, rotations_turn_at_constant_speed_the_short_way) {
  const auto aboutY = [](double angle) { return glm::dvec4(0, std::sin(angle / 2), 0, std::cos(angle / 2)); };
  const Scene scene =
      animated(Property::rotation, Interpolation::linear, {{0.0, aboutY(0.0)}, {1.0, -aboutY(1.2)}});
  const glm::dquat q = evaluatedAt(scene, 0.25).objects[0].transform.rotation;
  EXPECT_NEAR(glm::length(q), 1.0, 1e-15);
  EXPECT_NEAR(2 * std::atan2(q.y, q.w), 0.3, 1e-14);
}

TEST(Animation, light_never_turns_negative_when_a_cubic_overshoots) {
  const Scene scene =
      animated(Property::lightIntensity, Interpolation::cubic,
               {{0, {100, 0, 0, 0}}, {1, {0, 0, 0, 0}}, {2, {0, 0, 0, 0}}, {3, {100, 0, 0, 0}}});
  for (double t = 0.0; t < 3.0; t += 0.05)
    EXPECT_GE(std::get<Light>(evaluatedAt(scene, t).objects[0].content).intensity, 0.0f);
}

TEST(Animation, scale_keys_on_both_sides_of_zero_never_flatten_the_object) {
  const Scene scene =
      animated(Property::scale, Interpolation::linear, {{0, {-1, 1, 1, 0}}, {1, {1, 1, 1, 0}}});
  EXPECT_NE(evaluatedAt(scene, 0.5).objects[0].transform.scale.x, 0.0);
}

TEST(Animation, changes_nothing_but_its_targets) {
  Scene scene = animated(Property::lightColor, Interpolation::linear, {{0, {0.5, 0.25, 1, 0}}});
  scene.animation.channels.push_back(
      {Id(77), Property::translation, Interpolation::linear, {{0, {1, 1, 1, 0}}}});
  Scene expected = scene;
  std::get<Light>(expected.objects[0].content).color = {0.5f, 0.25f, 1.0f};
  EXPECT_EQ(evaluatedAt(scene, 3.0), expected);
}
