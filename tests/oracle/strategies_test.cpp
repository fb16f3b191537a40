// SPDX-License-Identifier: MIT
// The ways to gather light against each other, on plates that mirror lamps (after Veach 1997, fig. 9.2):
// Welch's t-test for every pixel between samples alone, paths alone, both, and paths that roulette ends.
#include "tests/oracle/statistics.hpp"
#include "tests/renderer/lights_fixture.hpp"

namespace steradian {
namespace {

/// Four plates, from glossy to dull, each turned so that it mirrors the lamps, before a wall. Welch's test
/// needs means that are nearly normal, so no strategy may live on rare bright events: the lamps are equally
/// bright, the smallest is met often enough to be seen among the others, and the smoothest lobe is as wide as
/// the lamps are. (Veach's own lamps send equal power, and paths alone hardly ever meet the smallest.)
Scene platesAndLamps() {
  Scene scene = plainScene(6);
  add(scene, at({0, 0, 0}), Plane{}, lambert({0.5f, 0.45f, 0.4f}));
  add(scene, at({0, 0, -3}, {1, 0, 0}, 0.5 * pi), Plane{}, lambert(glm::vec3(0.6f)));
  const float roughness[] = {0.35f, 0.45f, 0.55f, 0.7f};
  for (int i = 0; i < 4; ++i) {
    const dvec3 place(0, 0.2 + 0.25 * i, 1.2 - 0.8 * i), eye(0, 2.2, 7), lamps(0, 3.0, -1.0);
    const dvec3 normal = glm::normalize(glm::normalize(eye - place) + glm::normalize(lamps - place));
    const double tilt = std::atan2(normal.z, normal.y);
    add(scene, at(place, {1, 0, 0}, tilt), Box{{4.0, 0.05, 0.6}}, metal(roughness[i], {0.8f, 0.7f, 0.6f}));
  }
  const double radius[] = {0.25, 0.35, 0.45, 0.6};
  for (int i = 0; i < 4; ++i) add(scene, at({-1.8 + 1.2 * i, 3.0, -1.0}), Sphere{radius[i]}, emitter(4.0f));
  return scene;
}
const CameraView view = lookAt({0, 2.2, 7}, {0, 1.2, 0}, 0.6);

class Strategies : public LightsTest {
 protected:
  static constexpr int size = 24, samples = 128, seeds = 16;

  /// Every call draws seeds that no other call has: the strategies' pictures are independent.
  std::vector<Image> pictures(const Ablation& strategy, bool roulette = false) {
    ablate(strategy);
    Scene scene = platesAndLamps();
    scene.render.russianRoulette = roulette;
    renderer().allowSpecialization(true);  // for speed alone
    renderer().setScene(scene, view, {size, size});
    renderer().waitForSpecialization();
    std::vector<Image> images;
    for (int i = 0; i < seeds; ++i) {
      scene.render.seed = ++seed_;
      images.push_back(render(scene, view, {size, size}, samples));
    }
    return images;
  }
  static void expectAgreement(const oracle::Estimate& a, const oracle::Estimate& b, const char* what) {
    const oracle::Agreement pixels = oracle::compare(a, b);
    std::printf("%s: %s", what, report(pixels).c_str());
    EXPECT_GE(pixels.passing, 0.9975) << what << ": " << report(pixels);
    EXPECT_GT(pixels.uniformity, 1e-4) << what << ": " << report(pixels);
    EXPECT_GE(pixels.random, std::size_t(size * size) * 9 / 10) << "too little noise to test";
    measuredAtLeast("share of pixels that pass Welch's test (Sidak)", pixels.passing, 0.9975);
    measuredAtLeast("p of the evenness of the pixels' p-values", pixels.uniformity, 1e-4);
    for (const int tile : {4, size}) {
      const oracle::Agreement tiles = oracle::compare(a, b, tile);
      EXPECT_TRUE(tiles.holds()) << what << ", tiles of " << tile << " pixels: " << report(tiles);
    }
  }
  static oracle::Estimate scaled(std::vector<Image> images, float factor) {
    for (Image& image : images)
      for (float& value : image.pixels) value *= factor;
    return oracle::fromImages(images);
  }

 private:
  unsigned seed_ = 3200;
};

TEST_F(Strategies, row32_samples_alone_paths_alone_and_both_agree_in_every_pixel) {
  Ablation noHits, noSampling;
  noHits.lightHits = false;
  noSampling.lightSampling = false;
  const std::vector<Image> lightAlone = pictures(noHits);
  const oracle::Estimate both = oracle::fromImages(pictures({})), light = oracle::fromImages(lightAlone),
                         paths = oracle::fromImages(pictures(noSampling));
  expectAgreement(light, both, "samples alone / both");
  expectAgreement(paths, both, "paths alone / both");
  expectAgreement(paths, light, "paths alone / samples alone");
  EXPECT_LT(oracle::compare(scaled(lightAlone, 1.01f), both).uniformity, 1e-4) << "the test must bite";
}

TEST_F(Strategies, visible_and_all_normals_agree_in_every_pixel) {
  Ablation allNormals;
  allNormals.visibleNormals = false;
  const oracle::Estimate visible = oracle::fromImages(pictures({})),
                         all = oracle::fromImages(pictures(allNormals));
  expectAgreement(all, visible, "all normals / visible normals");
}

TEST_F(Strategies, row32_roulette_on_and_off_agree_in_every_pixel) {
  const std::vector<Image> on = pictures({}, true);
  expectAgreement(oracle::fromImages(on), oracle::fromImages(pictures({})), "roulette / none");
  Scene scene = platesAndLamps();
  scene.render.seed = 3201;
  EXPECT_NE(render(scene, view, {size, size}, samples).pixels, on[0].pixels) << "it ended no path";
}

}  // namespace
}  // namespace steradian
