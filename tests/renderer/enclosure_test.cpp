// SPDX-License-Identifier: MIT
// Closed rooms whose radiance is known everywhere: a leak at a corner or a lost bounce shows as darkness.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

enum class Room { sphere, box, mixed };

/// Emission `nit` and albedo `rho` on every surface.
Scene enclosure(Room kind, float rho, float nit, int bounces) {
  Scene scene = plainScene(bounces);
  const Id wall = add(scene, emitter(nit, glm::vec3(rho)));
  if (kind == Room::sphere) add(scene, at({0.3, 0.2, -0.5}), Sphere{3.0}, wall);
  if (kind != Room::sphere) add(scene, at({0.3, 0.2, -0.5}, {1, 2, 3}, 0.4), Box{{6, 5, 7}}, wall);
  if (kind == Room::mixed) {
    add(scene, at({0, -1, 0}), Plane{}, wall);
    add(scene, at({-1.5, 0, 0}, {0, 0, 1}, -1.3), Plane{}, wall);
    add(scene, at({0.8, -0.6, -1.5}), Sphere{0.7}, wall);  // cut by the floor
    add(scene, at({1.6, 0.4, -1.2}, {0, 0, 1}, 0.3, {0.3, 0.8, 0.5}), Sphere{1.0}, wall);
    add(scene, at({-0.3, -0.7, -2}, {0, 1, 0}, 0.5), Box{{0.6, 0.6, 0.6}}, wall);
    add(scene, at({0, 0.9, -2}, {1, 0, 0}, 0.7), Cylinder{0.3, 0.8}, wall);
    add(scene, at({0.9, 0.8, -2.4}, {1, 0, 0}, 1.1), Rect{{0.8, 0.5}}, wall);
    add(scene, at({-0.4, 0.2, -2.4}, {1, 1, 0}, 1.2), Disk{0.4}, wall);
  }
  return scene;
}

CameraView inside() {
  return lookAt({0.2, 0.1, 1.0}, {0.2, 0.0, -2.0}, 1.4);
}

/// 1 + rho + ... + rho^(bounces + 1): paths of so many bounces still meet what lies behind the last one.
double gathered(double rho, int bounces) {
  return (1.0 - std::pow(rho, bounces + 2)) / (1.0 - rho);
}

class EnclosureTest : public RendererTest {
 protected:
  void expectUniform(Room kind, float rho, int bounces) {
    SCOPED_TRACE(testing::Message() << "room " << int(kind) << ", albedo " << rho << ", bounces " << bounces);
    const float nit = 0.5f;
    const int samples = bounces > 8 ? 32 : 128;
    // By paths alone, which makes every sample the same number: a single leak shows.
    renderer().setAblation({.lightSampling = false});
    const Image image = render(enclosure(kind, rho, nit, bounces), inside(), {24, 24}, samples);
    renderer().setAblation({});
    const double expected = nit * gathered(rho, bounces);
    expectMean(meanOf(image), expected, 1e-4);
    double worst = 0.0;
    for (const float value : image.pixels) worst = std::max(worst, std::abs(value / expected - 1.0));
    // One path in a million may slip out where two shapes cross, which a pixel of few samples shows; one
    // shape is tight.
    EXPECT_LT(worst, kind == Room::mixed ? 1.0 / samples : 1e-4);
    measured("relative error of the worst pixel", worst, kind == Room::mixed ? 1.0 / samples : 1e-4);
  }
};

TEST_F(EnclosureTest, row33_sphere_holds_the_geometric_series_of_its_albedo) {
  for (const float rho : {0.5f, 0.9f})
    for (const int bounces : {8, 64}) expectUniform(Room::sphere, rho, bounces);
}

TEST_F(EnclosureTest, row33_box_holds_the_geometric_series_of_its_albedo) {
  for (const float rho : {0.5f, 0.9f})
    for (const int bounces : {8, 64}) expectUniform(Room::box, rho, bounces);
}

TEST_F(EnclosureTest, row33_mixed_shapes_hold_the_geometric_series_of_their_albedo) {
  for (const float rho : {0.5f, 0.9f})
    for (const int bounces : {8, 64}) expectUniform(Room::mixed, rho, bounces);
}

TEST_F(EnclosureTest, row33_sampled_light_keeps_the_series) {
  for (const int bounces : {0, 3, 8}) {
    const Scene scene = enclosure(Room::mixed, 0.9f, 0.5f, bounces);
    expectMean(meanOf(render(scene, inside(), {32, 32}, 128)), 0.5 * gathered(0.9, bounces), 0.0);
  }
}

TEST_F(EnclosureTest, row33_point_light_in_the_middle_of_a_sphere_lights_it_evenly) {
  Scene scene = plainScene(20);
  add(scene, at({0, 0, 0}), Sphere{2.0}, lambert(glm::vec3(0.7f)));
  addLight(scene, at({0, 0, 0}), PointLight{}, 3.0f);
  const Image image = render(scene, lookAt({0.5, 0.3, 1}, {0, 0, -1}, 1.2), {16, 16}, 64);
  expectMean(meanOf(image), 0.7 * 3.0 / (pi * 4.0) * gathered(0.7, 19), 1e-4);
}

TEST_F(EnclosureTest, row33_russian_roulette_keeps_the_mean) {
  Scene scene = enclosure(Room::mixed, 0.9f, 0.5f, 64);
  scene.render.russianRoulette = true;
  const Mean mean = meanOf(render(scene, inside(), {32, 32}, 128));
  EXPECT_GT(mean.sigma, 0.0);  // it did end paths
  expectMean(mean, 0.5 * gathered(0.9, 64), 0.0);
  EXPECT_LT(mean.sigma, 0.003 * mean.value);
}

TEST_F(EnclosureTest, row32_russian_roulette_on_and_off_agree_in_a_furnished_room) {
  Scene scene = room(12);
  const Image off = render(scene, roomView(), {32, 32}, 128);
  scene.render.russianRoulette = true;
  scene.render.seed = 7;
  const Image on = render(scene, roomView(), {32, 32}, 128);
  for (int channel = 0; channel < 3; ++channel) {
    const std::vector<double> a = channelOf(off, channel), b = channelOf(on, channel);
    std::vector<double> difference;
    for (std::size_t i = 0; i < a.size(); ++i) difference.push_back(b[i] - a[i]);
    const Mean mean = meanOf(difference);
    EXPECT_NEAR(mean.value, 0.0, 3.0 * mean.sigma);
    measured("difference of the means, standard errors", std::abs(mean.value) / mean.sigma, 3.0);
    EXPECT_LT(mean.sigma, 0.02 * meanOf(a).value);
  }
}

TEST_F(EnclosureTest, row34_two_infinite_planes_exchange_light_without_end) {
  Scene scene = plainScene(64);
  add(scene, at({0, 0, 0}), Plane{}, emitter(1.0f, glm::vec3(0.5f)));
  add(scene, at({0, 2, 0}, {1, 0, 0}, pi), Plane{}, lambert(glm::vec3(0.8f)));
  const Image image = render(scene, lookAt({0, 0.7, 0}, {0, 0.7, -1}, 1.0), {32, 32}, 64);
  std::vector<double> upper, lower;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) (y < 16 ? upper : lower).push_back(*image.at(x, y));
  expectMean(meanOf(lower), 1.666667, 0.005);
  expectMean(meanOf(upper), 1.333333, 0.005);
}

}  // namespace
}  // namespace steradian
