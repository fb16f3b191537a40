// SPDX-License-Identifier: MIT
// The figure that rays per second on a CPU driver are judged by.
#include "editor/cli/yardstick.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace steradian::bench {
namespace {

TEST(Yardstick, the_vector_units_give_a_finite_positive_figure_and_two_threads_no_less_than_one) {
  double one = 0.0, two = 0.0;
  for (int run = 0; run < 5; ++run) {  // the best, interleaved: a busy machine slows both
    one = std::max(one, vectorGflops(0.02, 1));
    two = std::max(two, vectorGflops(0.02, 2));
  }
  EXPECT_TRUE(std::isfinite(one));
  EXPECT_GT(one, 0.0);
  EXPECT_GT(two, 0.9 * one);
}

TEST(Yardstick, operations_per_ray_are_the_peak_over_the_rays) {
  EXPECT_NEAR(peakOperationsPerRay(113.0, 134.0), 843.3, 0.05);
  EXPECT_DOUBLE_EQ(peakOperationsPerRay(2.0, 1.0), 2000.0);
}

}  // namespace
}  // namespace steradian::bench
