// SPDX-License-Identifier: MIT
// Light from the sky: closed forms, and the same picture however its directions are found.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

/// Texels of one value, but for one.
std::shared_ptr<const Image> skyWithHotTexel(int width, int height, int column, int row, float hot,
                                             float others = 0.0f) {
  Image sky{width, height, 3, std::vector<float>(std::size_t(width) * height * 3, others)};
  for (int c = 0; c < 3; ++c) sky.at(column, row)[c] = hot;
  return std::make_shared<const Image>(std::move(sky));
}

void addSky(Scene& scene, std::shared_ptr<const Image> image, const Transform& place = at({0, 0, 0}),
            float intensity = 1.0f, glm::vec3 color = glm::vec3(1.0f)) {
  EnvironmentLight light;
  light.image = std::move(image);
  addLight(scene, place, light, intensity, color);
}

/// Integral of the cosine to the zenith over a texel of the upper half.
double cosineOver(int row, int columns, int rows) {
  const double top = std::cos(pi * row / rows), bottom = std::cos(pi * (row + 1) / rows);
  return (2.0 * pi / columns) * 0.5 * (top * top - bottom * bottom);
}

class SkyTest : public RendererTest {
 protected:
  void TearDown() override {
    renderer().setAblation({});
    RendererTest::TearDown();
  }
  /// Irradiance of a white matt ground.
  Mean irradiance(Scene scene, int samples, const Ablation& ablation = {}) {
    add(scene, at({0, 0, 0}), Plane{}, lambert(glm::vec3(1.0f)));
    renderer().setAblation(ablation);
    const Mean m = meanOf(render(scene, lookAt({3, 0.6, 4}, {0, 0, 0}, 1e-4), {32, 32}, samples));
    return {m.value * pi, m.sigma * pi};
  }
};

const Ablation sampledAlone{.lightHits = false};
const Ablation metAlone{.lightSampling = false};

TEST_F(SkyTest, row30_one_hot_texel_lights_the_same_by_each_strategy) {
  Scene scene = plainScene(1);
  addSky(scene, skyWithHotTexel(16, 8, 3, 2, 1e6f));
  const double expected = 1e6 * cosineOver(2, 16, 8);
  expectMean(irradiance(scene, 64, sampledAlone), expected, 0.01);
  expectMean(irradiance(scene, 2048, metAlone), expected, 0.01);
  expectMean(irradiance(scene, 64), expected, 0.01);
}

TEST_F(SkyTest, row30_holds_for_a_tiny_texel_beside_the_pole) {
  Scene scene = plainScene(1);
  addSky(scene, skyWithHotTexel(128, 64, 77, 0, 1e6f, 0.5f));
  const double dim = 0.5 * pi, hot = (1e6 - 0.5) * cosineOver(0, 128, 64);
  expectMean(irradiance(scene, 256, sampledAlone), dim + hot, 0.01);
  expectMean(irradiance(scene, 256), dim + hot, 0.01);
}

TEST_F(SkyTest, a_constant_sky_gives_pi_times_its_radiance) {
  for (const bool image : {false, true}) {
    Scene scene = plainScene(1);
    if (image)
      addSky(scene, skyWithHotTexel(7, 5, 0, 0, 2.0f, 2.0f));
    else
      addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 2.0f);
    for (const Ablation& ablation : {Ablation{}, sampledAlone, metAlone})
      expectMean(irradiance(scene, 64, ablation), 2.0 * pi, 0.003);
  }
}

// E = 2 pi times the integral of mu (h + (z - h) mu) over mu = pi (h / 3 + 2 z / 3).
TEST_F(SkyTest, a_gradient_gives_its_closed_form) {
  Scene scene = plainScene(1);
  addLight(scene, at({0, 0, 0}), EnvironmentLight{glm::vec3(0.25f), glm::vec3(7.0f)}, 3.0f);
  for (const Ablation& ablation : {Ablation{}, sampledAlone, metAlone})
    expectMean(irradiance(scene, 256, ablation), 3.0 * pi * (0.25 / 3.0 + 2.0 / 3.0), 0.003);
}

TEST_F(SkyTest, a_white_sphere_vanishes_in_a_constant_sky) {
  Scene scene = plainScene(4);
  add(scene, at({0, 0, 0}), Sphere{1.0}, lambert(glm::vec3(1.0f)));
  addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
  const Image image = render(scene, lookAt({0, 1, 3}, {0, 0, 0}, 0.9), {32, 32}, 64);
  expectMean(meanOf(image), 1.0, 0.001);
  double worst = 0.0;
  for (const float v : image.pixels) worst = std::max(worst, std::abs(double(v) - 1.0));
  EXPECT_LT(worst, 0.2) << "single pixels are only noisy";
}

/// What the camera sees of the sky, without anything before it.
glm::vec3 seen(Renderer& renderer, const Scene& scene, const dvec3& direction) {
  renderer.setScene(scene, lookAt({5, 6, 7}, dvec3(5, 6, 7) + direction, 1e-6), {1, 1});
  renderer.setSampleRange(0, 1);
  while (renderer.trace(50.0)) {
  }
  const Image image = renderer.radiance();
  return {image.pixels[0], image.pixels[1], image.pixels[2]};
}

TEST_F(SkyTest, the_centre_column_lies_along_minus_z_and_turns_with_the_object) {
  const dvec3 beside(0.02, 0.01, -1.0);  // within the texel right of the centre, just above the horizon
  const auto hot = skyWithHotTexel(16, 8, 8, 3, 5.0f);
  Scene scene = plainScene(0);
  addSky(scene, hot);
  EXPECT_EQ(seen(renderer(), scene, beside).x, 5.0f);
  EXPECT_EQ(seen(renderer(), scene, beside * dvec3(-1, 1, 1)).x, 0.0f);
  EXPECT_EQ(seen(renderer(), scene, beside * dvec3(1, -1, 1)).x, 0.0f);
  EXPECT_EQ(seen(renderer(), scene, beside * dvec3(1, 1, -1)).x, 0.0f);
  Scene turned = plainScene(0);
  const Transform place = at({10, 20, 30}, {1, 2, 3}, 1.2, {2, 2, 2});
  addSky(turned, hot, place);
  EXPECT_EQ(seen(renderer(), turned, place.rotation * beside).x, 5.0f);
  EXPECT_EQ(seen(renderer(), turned, beside).x, 0.0f);
}

TEST_F(SkyTest, image_colour_intensity_and_gradient_multiply) {
  Scene scene = plainScene(0);
  EnvironmentLight light{glm::vec3(0.5f), glm::vec3(0.25f)};
  light.image = skyWithHotTexel(4, 2, 0, 0, 3.0f, 3.0f);
  addLight(scene, at({0, 0, 0}), light, 2.0f, {1.0f, 0.5f, 0.0f});
  const auto near = [](glm::vec3 a, glm::vec3 b) { return glm::length(a - b) < 1e-4f; };
  EXPECT_TRUE(near(seen(renderer(), scene, {1e-3, 1, 0}), 3.0f * 2.0f * glm::vec3(1, 0.5, 0)));
  EXPECT_TRUE(near(seen(renderer(), scene, {1e-3, -1, 0}), 3.0f * 2.0f * 0.25f * glm::vec3(1, 0.5, 0)));
  EXPECT_TRUE(near(seen(renderer(), scene, {0, 1e-9, -1}), 3.0f * 2.0f * 0.5f * glm::vec3(1, 0.5, 0)));
}

TEST_F(SkyTest, specialized_and_generic_pipelines_give_the_same_bytes) {
  for (const bool image : {false, true}) {
    Scene scene = plainScene(3);
    add(scene, at({0, -1, 0}), Plane{}, lambert(glm::vec3(0.7f)));
    add(scene, at({0, 0, 0}), Sphere{1.0}, plastic(0.3f, glm::vec3(0.4f, 0.5f, 0.6f)));
    EnvironmentLight light{glm::vec3(0.5f), glm::vec3(0.25f)};
    if (image) light.image = skyWithHotTexel(16, 8, 3, 2, 100.0f, 0.3f);
    addLight(scene, at({0, 0, 0}, {1, 2, 3}, 0.4), light, 2.0f);
    const CameraView view = lookAt({0, 1, 5}, {0, 0, 0}, 0.8);
    renderer().allowSpecialization(false);
    const Image generic = render(scene, view, {16, 16}, 8);
    renderer().allowSpecialization(true);
    renderer().setScene(scene, view, {16, 16});
    renderer().waitForSpecialization();
    renderer().setSampleRange(0, 8);
    const Image special = render(scene, view, {16, 16}, 8);
    EXPECT_TRUE(renderer().stats().variant.specialized);
    if (onCpu()) {
      EXPECT_TRUE(special == generic) << image;
    } else {
      EXPECT_LE(mrse(special, generic), 1e-6) << image;
    }
  }
}

}  // namespace
}  // namespace steradian
