// SPDX-License-Identifier: MIT
// What a film counts in: a function of exposure and brightest emission.
#include "renderer/film_unit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/renderer/scenes.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian {
namespace {

using namespace scenes;

double unitOf(const Scene& scene) {
  return packScene(scene, {}, {8, 8}).filmUnit;
}

TEST(FilmUnit, follows_what_the_exposure_shows_as_white) {
  Scene scene = plainScene(1);
  EXPECT_EQ(unitOf(scene), 4096.0);
  scene.display.exposure = 3.0f;
  EXPECT_EQ(unitOf(scene), 512.0);
  scene.display.exposure = 0.0f;
  scene.display.physical = true;
  scene.display.ev100 = 15.0f;
  EXPECT_EQ(unitOf(scene), 4096.0 * 65536.0) << "white is 1.2 * 2^15 nit";
}

TEST(FilmUnit, leaves_room_for_a_million_samples_of_the_brightest) {
  Scene lamp = plainScene(1);
  add(lamp, at({0, 0, 0}), Sphere{1.0}, emitter(1e9f));
  EXPECT_EQ(unitOf(lamp), 0x1p20);
  Scene sun = plainScene(1);
  DirectionalLight disc;
  disc.angularDiameter = 0.01f;
  addLight(sun, at({0, 0, 0}), disc, 1e5f);
  EXPECT_EQ(unitOf(sun), std::exp2(std::ceil(std::log2(1e5 / (std::numbers::pi * 25e-6) / 1024))));
  Scene sky = plainScene(1);
  EnvironmentLight around;
  around.image = std::make_shared<Image>(Image{2, 1, 3, {0, 0, 0, 0, 60000, 0}});
  addLight(sky, at({0, 0, 0}), around, 1000.0f);
  EXPECT_EQ(unitOf(sky), 65536.0);
}

TEST(FilmUnit, counts_textures_that_glow_beyond_one) {
  for (const float texel : {0.5f, 64.0f}) {
    Scene scene = plainScene(1);
    Material screen = emitter(1e9f);
    screen.emissionTexture = textures::slot(textures::made(
        2, 2, textures::Format::rgbaHalf, [&](int x, int y) { return glm::vec4(0, x * y * texel, 0, 1); }));
    add(scene, at({0, 0, 0}), textures::shape(textures::picture()), screen);
    EXPECT_EQ(unitOf(scene), texel > 1.0f ? 0x1p26 : 0x1p20);
  }
}

TEST(FilmUnit, is_a_power_of_two_whatever_the_scene) {
  for (const float emission : {0.0f, 1e-38f, 7.0f, std::numeric_limits<float>::max()})
    for (const float exposure : {-1000.0f, -20.0f, 0.3f, 1000.0f}) {
      DisplaySettings display;
      display.exposure = exposure;
      const float unit = filmUnit(emission, display);
      int exponent;
      EXPECT_EQ(std::frexp(unit, &exponent), 0.5f) << unit;
      EXPECT_TRUE(std::isnormal(1.0f / unit)) << unit;
    }
}

}  // namespace
}  // namespace steradian
