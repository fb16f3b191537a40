// SPDX-License-Identifier: MIT
// The film as a measuring instrument: its sums stay exact, and its own figure of error is true.
#include "renderer/still.hpp"
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

class EstimatorTest : public RendererTest {
 protected:
  double trueRmse(const Image& image, const Image& reference) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      sum += std::pow(double(image.pixels[i]) - reference.pixels[i], 2);
    return std::sqrt(sum / double(image.pixels.size()));
  }

  /// The estimate after `samples`, against a longer picture of another seed whose own error is taken off.
  void expectHonestMeter(Scene scene, const CameraView& view, int samples) {
    const int more = 32;
    const Extent film{48, 48};
    const Image image = render(scene, view, film, samples);
    const ErrorEstimate estimate = renderer().measureError();
    ASSERT_TRUE(estimate.valid);
    scene.render.seed = 99;
    const Image reference = render(scene, view, film, samples * more);
    const double ownError = renderer().measureError().rmse;
    const double truth = std::sqrt(std::pow(trueRmse(image, reference), 2) - ownError * ownError);
    EXPECT_GT(truth, 0.0);
    EXPECT_NEAR(estimate.rmse / truth, 1.0, 0.1);
    measured("distance of estimate / truth from 1", std::abs(estimate.rmse / truth - 1.0), 0.1);
  }
};

TEST_F(EstimatorTest, row36_hundred_thousand_samples_of_a_constant_stay_exact) {
  Scene scene = plainScene(0);
  add(scene, at({0, 0, 0}), Sphere{1.0}, emitter(0.1f));
  for (const bool errorMeter : {true, false}) {
    scene.render.errorMeter = errorMeter;
    const Image image = render(scene, lookAt({0, 0, 0}, {0, 0, -1}, 1.0), {4, 4}, 120'000);
    for (const float value : image.pixels) {
      ASSERT_NEAR(value / 0.1f, 1.0f, 1e-6f);
      measured("relative error of the mean", std::abs(double(value / 0.1f) - 1.0), 1e-6);
    }
  }
}

TEST_F(EstimatorTest, tails_read_in_slices_are_those_of_the_whole_film) {
  const Extent film{32, 24};
  render(room(4), roomView(), film, 8);
  ASSERT_TRUE(renderer().measureError().valid);
  const ErrorTails whole = renderer().measureTails();
  EXPECT_EQ(whole.pixels, 1u);
  EXPECT_GT(whole.share, 1.0 / (32 * 24));
  int slices = 1;
  while (!renderer().measureTails(100)) ++slices;  // 3 rows each
  EXPECT_EQ(slices, 8);
  EXPECT_EQ(renderer().stats().error.tails, whole);
  // A picture that starts over drops what was read of the last one.
  EXPECT_FALSE(renderer().measureTails(100));
  Scene other = room(4);
  other.render.seed = 5;
  render(other, roomView(), film, 8);
  renderer().measureError();
  for (slices = 1; !renderer().measureTails(100);) ++slices;
  EXPECT_EQ(slices, 8);
  const ErrorTails sliced = renderer().stats().error.tails;
  EXPECT_EQ(sliced, renderer().measureTails());
}

TEST_F(EstimatorTest, row38_meter_is_true_in_a_room_of_area_lights) {
  expectHonestMeter(room(4), roomView(), 16);
}

TEST_F(EstimatorTest, row38_meter_is_true_at_hard_edges) {
  Scene scene = plainScene(0);
  for (int i = 0; i < 24; ++i)
    add(scene,
        at({std::cos(i * 1.1) * (0.2 + 0.03 * i), std::sin(i * 1.9) * (0.2 + 0.03 * i), -3.0 - 0.1 * i}),
        Sphere{0.15}, emitter(float(1 + i % 4)));
  scene.render.filter = PixelFilter::blackmanHarris;
  expectHonestMeter(scene, lookAt({0, 0, 0}, {0, 0, -1}, 0.6), 16);
}

TEST_F(EstimatorTest, row38_meter_is_true_for_lights_chosen_at_random) {
  Scene scene = plainScene(1);
  add(scene, at({0, 0, 0}), Plane{}, plastic(0.4f, {0.5f, 0.6f, 0.7f}));
  for (int i = 0; i < 30; ++i)
    addLight(scene, at({4.0 * std::cos(i * 1.7), 1.0 + 0.1 * i, 4.0 * std::sin(i * 2.3)}), PointLight{},
             1.0f + float(i % 3));
  scene.render.lightSamples = 3;
  expectHonestMeter(scene, lookAt({0, 3, 6}, {0, 0, 0}, 0.9), 16);
}

TEST_F(EstimatorTest, row38_meter_is_true_for_a_small_light_found_by_chance) {
  Scene scene = plainScene(1);
  add(scene, at({0, 0, 0}), Plane{}, lambert(glm::vec3(0.8f)));
  add(scene, at({0, 2, 0}), Sphere{0.5}, emitter(20.0f));
  expectHonestMeter(scene, lookAt({0, 1, 6}, {0, 0, 0}, 0.4), 64);
}

TEST_F(EstimatorTest, progress_of_a_still_moves_within_a_pass_and_never_back) {
  renderer().setScene(room(2), roomView(), {64, 192});
  StillRequest request;
  request.spp = 48;
  request.batchMs = 0.01;  // as few rows at a time as there are
  std::vector<StillProgress> seen;
  renderStill(renderer(), request, {[&](const StillProgress& now) { seen.push_back(now); }, {}});
  std::size_t within = 0;
  for (std::size_t i = 1; i < seen.size(); ++i) {
    EXPECT_GE(seen[i].fraction, seen[i - 1].fraction);
    within += seen[i].samples == seen[i - 1].samples && seen[i].fraction > seen[i - 1].fraction;
  }
  EXPECT_GT(within, seen.size() / 2);
  EXPECT_EQ(seen.back().fraction, 1.0);
}

TEST_F(EstimatorTest, ErrorFallsAtLeastAsFastAsTheSquareRootOfTheSamples) {
  render(room(2), roomView(), {48, 48}, 16);
  const double coarse = renderer().measureError().rmse;
  renderer().setSampleRange(0, 256);
  while (renderer().trace(200.0)) {
  }
  const double slope = std::log(renderer().measureError().rmse / coarse) / std::log(16.0);
  EXPECT_LT(slope, -0.45);
  EXPECT_GT(slope, -1.5);
}

}  // namespace
}  // namespace steradian
