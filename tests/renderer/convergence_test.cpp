// SPDX-License-Identifier: MIT
// Slope, time to a target and the warning of heavy tails, on figures with known answers.
#include "renderer/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/film_sums.hpp"

using namespace steradian;

namespace {

SlopeTracker trackerOf(double exponent, int points, double wobble = 0.0) {
  SlopeTracker tracker;
  for (int i = 0; i < points; ++i) {
    const double n = double(2u << i);
    tracker.add(std::uint64_t(n), std::pow(n, exponent) * (1.0 + (i % 2 ? wobble : -wobble)));
  }
  return tracker;
}

ErrorEstimate estimate(double slope, int doublings, double share) {
  ErrorEstimate error{0.1, 0.1, slope, true, doublings, {share, 4, false}};
  error.tails.heavy = heavyTails(error);
  return error;
}

/// Means of A and B differ by `difference` in every value, by `worst` in pixel 0.
FilmSums sumsDiffering(int pixels, int difference, int worst) {
  FilmSums sums{pixels, 1};
  sums.end = sums.endAhead = 2;
  sums.errorMeter = true;
  for (const int half : {0, 1}) {
    sums.sums[half].resize(std::size_t(pixels) * 3);
    for (std::size_t i = 0; i < sums.sums[half].size(); ++i)
      sums.sums[half][i].high = half * (i < 3 ? worst : difference);
  }
  return sums;
}

}  // namespace

TEST(Slope, is_that_of_a_power_law) {
  EXPECT_DOUBLE_EQ(trackerOf(-0.5, 2).slope(), -0.5);
  EXPECT_NEAR(trackerOf(-0.7, 12).slope(), -0.7, 1e-12);
  EXPECT_EQ(trackerOf(-0.7, 12).doublings(), 4);
  EXPECT_EQ(SlopeTracker().slope(), 0.0);
  EXPECT_EQ(trackerOf(-0.7, 1).slope(), 0.0);
}

TEST(Slope, over_several_doublings_is_steadier_than_over_one) {
  // A wobble of 5 % turns the slope of one doubling by log2(1.05 / 0.95) = 0.144.
  EXPECT_NEAR(std::abs(trackerOf(-0.5, 2, 0.05).slope() + 0.5), 0.144, 0.001);
  EXPECT_LT(std::abs(trackerOf(-0.5, 8, 0.05).slope() + 0.5), 0.03);
}

TEST(Slope, forgets_how_the_render_began) {
  SlopeTracker tracker;
  for (int i = 0; i < 5; ++i) tracker.add(2u << i, 1.0);
  for (int i = 5; i < 12; ++i) tracker.add(2u << i, std::pow(2.0, -0.5 * i));
  EXPECT_NEAR(tracker.slope(), -0.5, 1e-12);
}

TEST(Slope, looks_only_at_doublings) {
  SlopeTracker tracker;
  tracker.add(16, 1.0);
  tracker.add(17, 0.5);
  EXPECT_EQ(tracker.doublings(), 0);
  tracker.add(32, 0.5);
  EXPECT_DOUBLE_EQ(tracker.slope(), -1.0);
}

TEST(SamplesNeeded, follow_the_slope_and_believe_a_slow_one_only_after_three_doublings) {
  const auto needed = [](double slope, int doublings) {
    return samplesNeeded(100, {0.02, 0.02, slope, true, doublings, {}}, 0.01);
  };
  EXPECT_DOUBLE_EQ(needed(0.0, 0), 400.0);
  EXPECT_DOUBLE_EQ(needed(-1.0, 1), 200.0);
  EXPECT_DOUBLE_EQ(needed(-0.4, 2), 400.0);
  EXPECT_NEAR(needed(-0.4, 3), 100.0 * std::pow(2.0, 2.5), 1e-9);
  EXPECT_DOUBLE_EQ(needed(0.1, 3), 1600.0);  // fireflies come faster than they fade: the slowest of all
}

TEST(Tails, of_even_errors_carry_what_they_count) {
  const ErrorTails tails = tailsOf(sumsDiffering(10000, 1, 1));
  EXPECT_EQ(tails.pixels, 10u);
  EXPECT_NEAR(tails.share, 0.001, 1e-12);
}

TEST(Tails, of_one_firefly_carry_nearly_all) {
  const ErrorTails tails = tailsOf(sumsDiffering(1000, 1, 100));
  EXPECT_EQ(tails.pixels, 1u);
  EXPECT_NEAR(tails.share, 1e4 / (1e4 + 999.0), 1e-9);
}

TEST(Tails, are_not_measured_without_two_halves_and_are_nothing_without_error) {
  FilmSums sums = sumsDiffering(10, 0, 0);
  EXPECT_EQ(tailsOf(sums).share, 0.0);
  sums.errorMeter = false;
  EXPECT_EQ(tailsOf(sums).pixels, 0u);
}

TEST(Tails, weigh_the_rows_of_a_pass_under_way_by_their_own_samples) {
  FilmSums sums = sumsDiffering(10, 1, 1);
  sums.end = 2;
  sums.endAhead = 4;
  sums.rowsAhead = 1;
  EXPECT_EQ(sums.count(0, 0), 2u);
  EXPECT_EQ(sums.count(0, 1), 1u);
}

TEST(HeavyTails, need_a_flat_slope_over_three_doublings_and_few_pixels_with_most_of_the_error) {
  EXPECT_TRUE(estimate(-0.3, 3, 0.6).tails.heavy);
  EXPECT_FALSE(estimate(-0.5, 3, 0.6).tails.heavy);
  EXPECT_FALSE(estimate(-0.3, 2, 0.6).tails.heavy);
  EXPECT_FALSE(estimate(-0.3, 3, 0.4).tails.heavy);
  EXPECT_NE(tailWarning(estimate(-0.3, 3, 0.6)).find("4 pixels carry 60 % of the squared error"),
            std::string::npos);
  EXPECT_NE(tailWarning(estimate(-0.3, 3, 0.6)).find("falls as samples^-0.30 only"), std::string::npos);
  EXPECT_NE(tailWarning(estimate(0.1, 3, 0.6)).find("does not fall"), std::string::npos);
  EXPECT_TRUE(tailWarning(estimate(-0.5, 3, 0.6)).empty());
}

TEST(ClampWarning, tells_the_share_of_the_light_and_only_when_some_is_gone) {
  RenderStats stats;
  EXPECT_TRUE(clampWarning(stats).empty());
  stats.clampedShare = 0.0;
  EXPECT_TRUE(clampWarning(stats).empty());
  stats.clampedShare = 0.0321;
  EXPECT_NE(clampWarning(stats).find("removed 3.2 % of the light"), std::string::npos);
  stats.nanSamples = 2;
  EXPECT_EQ(doubtsAbout(stats).size(), 2u);
}
