// SPDX-License-Identifier: MIT
// What progress promises.
#include <gtest/gtest.h>

#include "editor/cli/report_progress.hpp"

using steradian::cli::remainingOf;

TEST(ReportProgress, knows_what_is_left_once_a_hundredth_is_done) {
  EXPECT_FALSE(remainingOf(1.0, 4, 0, 0.0));
  EXPECT_FALSE(remainingOf(1.0, 4, 0, 0.01));
  EXPECT_DOUBLE_EQ(*remainingOf(10.0, 1, 0, 0.25), 30.0);
  EXPECT_DOUBLE_EQ(*remainingOf(30.0, 4, 1, 0.5), 50.0);  // 1.5 of 4 scenes
  EXPECT_DOUBLE_EQ(*remainingOf(30.0, 2, 1, 1.0), 0.0);
}
