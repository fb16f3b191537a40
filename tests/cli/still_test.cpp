// SPDX-License-Identifier: MIT
// When the convergence loop looks at its error.
#include "renderer/still.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace steradian;

namespace {
ErrorEstimate estimate(double relRmse, double slope = -0.5) {
  return {relRmse, relRmse, slope, true};
}
}  // namespace

TEST(NextMeasurement, doubles_while_nothing_is_known_or_the_target_is_far) {
  EXPECT_EQ(nextMeasurement(0, {}, 0.01), 2u);
  EXPECT_EQ(nextMeasurement(8, {}, 0.01), 16u);
  EXPECT_EQ(nextMeasurement(64, estimate(1.0), 0.01), 128u);
}

TEST(NextMeasurement, aims_at_the_target_once_it_is_near) {
  EXPECT_EQ(nextMeasurement(1000, estimate(0.012), 0.01), 1440u);        // (1.2)^2
  EXPECT_EQ(nextMeasurement(1000, estimate(0.012, -1.0), 0.01), 1200u);  // Owen-Sobol on a smooth image
  EXPECT_EQ(nextMeasurement(1000, estimate(0.01001), 0.01), 1062u);      // never less than a sixteenth ahead
}

TEST(NextMeasurement, reaches_a_target_with_few_measurements_and_little_overshoot) {
  // relRmse = n^-1/2 reaches 1 % at 10,000 samples.
  std::uint64_t samples = 2;
  int measurements = 1;
  for (; 1.0 / std::sqrt(double(samples)) > 0.01; ++measurements)
    samples = nextMeasurement(samples, estimate(1.0 / std::sqrt(double(samples))), 0.01);
  EXPECT_LE(measurements, 16);
  EXPECT_LE(samples, 11000u);
}
