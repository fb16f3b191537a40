// SPDX-License-Identifier: MIT
// What the tests of lights share: a ground, its irradiance, and the strategies that must agree.
#pragma once
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {

using namespace scenes;

/// A light at `position` that shines along `direction`.
inline Transform shining(const dvec3& position, const dvec3& direction, const dvec3& scale = dvec3(1.0)) {
  return {position, facing(direction), scale};
}

inline Scene ground(const Material& material = lambert(glm::vec3(1.0f)), int bounces = 1) {
  Scene scene = plainScene(bounces);
  add(scene, at({0, 0, 0}), Plane{}, material);
  return scene;
}

class LightsTest : public RendererTest {
 protected:
  void TearDown() override {
    renderer().setAblation({});
    RendererTest::TearDown();
  }
  /// The generic pipeline obeys no ablation.
  void ablate(const Ablation& ablation) {
    renderer().allowSpecialization(ablation != Ablation{});
    renderer().setAblation(ablation);
  }
  /// Irradiance of the matt ground at a point.
  Mean irradiance(const Scene& scene, const dvec3& point, int samples) {
    const CameraView view = lookAt(point + dvec3(3.0, 0.1, 4.0), point, 2e-5);  // below most lights
    const Mean radiance = meanOf(render(scene, view, {16, 16}, samples));
    return {radiance.value * pi, radiance.sigma * pi};
  }
  /// Light samples alone, paths alone and both together give the same picture.
  void expectStrategiesAgree(const Scene& scene, const CameraView& view, std::uint64_t samples) {
    Ablation noSampling, noHits;
    noSampling.lightSampling = false;
    noHits.lightHits = false;
    ablate({});
    const Image both = render(scene, view, {16, 16}, samples);
    for (const Ablation& strategy : {noSampling, noHits}) {
      SCOPED_TRACE(strategy.lightSampling ? "samples alone" : "paths alone");
      ablate(strategy);
      const Image alone = render(scene, view, {16, 16}, samples);
      EXPECT_NE(alone.pixels, both.pixels) << "the strategy was not switched";
      // Pixels differ in their noise, not in their means: compare one by one.
      std::vector<double> differences;
      for (std::size_t i = 0; i < both.pixels.size(); i += 3)
        differences.push_back(double(alone.pixels[i]) - both.pixels[i]);
      const Mean difference = meanOf(differences);
      EXPECT_NEAR(difference.value, 0.0, 3.0 * difference.sigma);
      measured("difference of the means, standard errors", std::abs(difference.value) / difference.sigma,
               3.0);
      EXPECT_LT(difference.sigma, 0.01 * meanOf(both).value) << "too noisy to tell";
    }
  }
};

}  // namespace steradian
