// SPDX-License-Identifier: MIT
// The figure that rays per second on a CPU driver are judged by.
#include "editor/cli/yardstick.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steradian::bench {
namespace {

TEST(Yardstick, the_vector_units_give_a_finite_positive_figure_on_one_thread_and_on_two) {
  for (const unsigned threads : {1u, 2u}) {
    const double gflops = vectorGflops(0.02, threads);
    EXPECT_TRUE(std::isfinite(gflops)) << threads;
    EXPECT_GT(gflops, 0.0) << threads;
  }
}

TEST(Yardstick, operations_per_ray_are_the_peak_over_the_rays) {
  EXPECT_NEAR(peakOperationsPerRay(113.0, 134.0), 843.3, 0.05);
  EXPECT_DOUBLE_EQ(peakOperationsPerRay(2.0, 1.0), 2000.0);
}

}  // namespace
}  // namespace steradian::bench
