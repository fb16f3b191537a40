// SPDX-License-Identifier: MIT
// Medians, fits and crossings with known answers.
#include "editor/report/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "editor/report/report.hpp"

using namespace steradian::report;

TEST(Statistics, the_median_is_in_the_middle) {
  EXPECT_EQ(median({3.0, 1.0, 100.0}), 3.0);
  EXPECT_EQ(median({4.0, 1.0, 2.0, 100.0}), 3.0);
  EXPECT_EQ(median({}), 0.0);
  const Spread spread = spreadOf({5.0, 2.0, 9.0});
  EXPECT_EQ(spread.least, 2.0);
  EXPECT_EQ(spread.median, 5.0);
  EXPECT_EQ(spread.most, 9.0);
}

TEST(Statistics, a_power_law_is_found_again_also_from_far_away_numbers) {
  std::vector<Point> points{{0.0, 1.0}, {1.0, -1.0}};  // no logarithms: left out
  for (double x = 1e-6; x < 1e6; x *= 7.0) points.push_back({x, 0.03 * std::pow(x, -0.62)});
  const auto law = fitPowerLaw(points);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, -0.62, 1e-12);
  EXPECT_NEAR(law->factor, 0.03, 1e-12);
  EXPECT_NEAR(law->reaching(law->at(42.0)), 42.0, 1e-9);
  EXPECT_FALSE(fitPowerLaw(std::vector<Point>{{1.0, 1.0}}));
  EXPECT_FALSE(fitPowerLaw(std::vector<Point>{{1.0, 1.0}, {1.0, 2.0}}));
}

TEST(Statistics, a_fit_is_least_squares) {
  // log points (0,0) (1,1) (2,0): slope 0, level 1/3.
  const double e = std::exp(1.0);
  const auto law = fitPowerLaw(std::vector<Point>{{1.0, 1.0}, {e, e}, {e * e, 1.0}});
  EXPECT_NEAR(law->exponent, 0.0, 1e-12);
  EXPECT_NEAR(std::log(law->factor), 1.0 / 3.0, 1e-12);
}

TEST(Statistics, a_target_is_met_between_points_or_beyond_them) {
  const std::vector<Point> points{{1.0, 0.08}, {4.0, 0.04}, {16.0, 0.02}};  // 0.08 x^-1/2
  const PowerLaw law{0.08, -0.5};
  const auto between = crossingOf(points, law, 0.04 / std::sqrt(2.0));
  EXPECT_NEAR(between->x, 8.0, 1e-9);
  EXPECT_FALSE(between->extrapolated);
  const auto beyond = crossingOf(points, law, 0.01);
  EXPECT_NEAR(beyond->x, 64.0, 1e-9);
  EXPECT_TRUE(beyond->extrapolated);
  EXPECT_FALSE(crossingOf(points, law, 0.5));
  EXPECT_FALSE(crossingOf(points, {0.08, 0.1}, 0.01));
}

TEST(Curve, is_the_median_of_its_runs_with_slope_time_and_efficiency) {
  std::vector<std::vector<Sample>> runs(3);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::uint64_t n = 1; n <= 64; n *= 2) {
      const double relRmse = 0.4 / std::sqrt(double(n)) * (r == 2 ? 3.0 : 1.0);  // one run is an outlier
      const double relMse = relRmse * relRmse, mse = 4.0 * relMse;
      runs[r].push_back({n, 0.01 * double(n), mse, relMse, 0.1, 1.21 * mse, 0.81 * relMse});
    }
  const Curve curve = curveOf("id", "label", runs);
  ASSERT_EQ(curve.points.size(), 7u);
  EXPECT_NEAR(curve.points.back().relRmse.median, 0.05, 1e-12);
  EXPECT_NEAR(curve.points.back().relRmse.most, 0.15, 1e-12);
  EXPECT_NEAR(curve.relRmseOverSamples->exponent, -0.5, 1e-9);
  EXPECT_NEAR(curve.secondsToTarget->x, 16.0, 1e-6);  // 0.64 s * (5 % / 1 %)^2
  EXPECT_TRUE(curve.secondsToTarget->extrapolated);
  EXPECT_NEAR(curve.efficiency, 1.0 / (0.01 * 0.64), 1e-6);
  EXPECT_NEAR(curve.points.back().meterRatio, 1.1, 1e-9);
  EXPECT_NEAR(curve.points.back().relMeterRatio, 0.9, 1e-9);
}
