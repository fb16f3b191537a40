// SPDX-License-Identifier: MIT
// Metrics against figures worked out by hand.
#include "editor/cli/image_compare.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/scene/error.hpp"

using namespace steradian;
using namespace steradian::cli;

TEST(ImageCompare, equal_images_differ_by_nothing) {
  const Image image{2, 1, 3, {1, 2, 3, 0, 0, 0}};
  const ImageDifference d = differenceOf(image, image);
  EXPECT_EQ(d.mse, 0.0);
  EXPECT_EQ(d.smape, 0.0);
  EXPECT_EQ(d.meanRatio, (std::array{1.0, 1.0, 1.0}));
}

TEST(ImageCompare, follows_the_definitions) {
  const Image a{1, 1, 3, {1, 2, 0}}, b{1, 1, 3, {3, 2, 0}};
  const ImageDifference d = differenceOf(a, b);
  EXPECT_DOUBLE_EQ(d.mse, 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(d.relMse, 4.0 / 9.01 / 3.0);
  EXPECT_DOUBLE_EQ(d.relRmse, std::sqrt(d.relMse));
  EXPECT_DOUBLE_EQ(d.smape, 2.0 * 2.0 / 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(d.max, 2.0);
  EXPECT_DOUBLE_EQ(d.meanRatio[0], 1.0 / 3.0);
}

TEST(ImageCompare, weighs_what_a_screen_shows) {
  // sRGB of 0.5 is 0.735357, of 0.25 is 0.537099; 2 is clipped to 1, so it equals 1; below black is black.
  const Image a{1, 1, 3, {0.5f, 2.0f, -1.0f}}, b{1, 1, 3, {0.25f, 1.0f, 0.0f}};
  EXPECT_NEAR(differenceOf(a, b).smapeDisplay, 2.0 * (0.735357 - 0.537099) / (0.735357 + 0.537099) / 3.0,
              1e-6);
  const Encodings encoded{Encoding::display, Encoding::display};
  EXPECT_NEAR(differenceOf(a, b, encoded).smapeDisplay, 2.0 * 0.25 / 0.75 / 3.0, 1e-12);
}

TEST(ImageCompare, a_limit_names_a_figure_and_what_exceeds_it) {
  const Image a{1, 1, 3, {1, 2, 0}}, b{1, 1, 3, {3, 2, 0}}, bad{1, 1, 3, {NAN, 2, 0}};
  EXPECT_TRUE(exceeded(differenceOf(a, b), {parseLimit("max=2")}).empty());
  EXPECT_EQ(exceeded(differenceOf(a, b), {parseLimit("max=1.5"), parseLimit("mse=1")}),
            (std::vector<std::string>{"max is 2, above 1.5", "mse is 1.33333, above 1"}));
  EXPECT_EQ(exceeded(differenceOf(bad, b), {parseLimit("max=100")}).size(), 1u);
  for (const char* wrong : {"rmse", "rmse=", "rmse=x", "size=1", "=1", "rmse=-1", "rmse=nan"})
    EXPECT_THROW(parseLimit(wrong), Error) << wrong;
}

TEST(ImageCompare, counts_what_is_not_finite_and_leaves_it_out) {
  const Image a{1, 1, 3, {NAN, INFINITY, 2}}, b{1, 1, 3, {1, 1, 1}};
  const ImageDifference d = differenceOf(a, b);
  EXPECT_EQ(d.nan, 1u);
  EXPECT_EQ(d.inf, 1u);
  EXPECT_DOUBLE_EQ(d.mse, 1.0);
}

TEST(ImageCompare, takes_alpha_and_grey_images_and_refuses_other_sizes) {
  const Image rgba{1, 1, 4, {1, 1, 1, 0}}, grey{1, 1, 1, {1}}, wide{2, 1, 1, {1, 1}};
  EXPECT_EQ(differenceOf(rgba, grey).max, 0.0);
  EXPECT_THROW(differenceOf(rgba, wide), Error);
}
