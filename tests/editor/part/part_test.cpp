// SPDX-License-Identifier: MIT
// Parts of a still: merging is exact, in any order and grouping, and refuses what does not belong together.
#include "editor/part/part.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace steradian;

namespace {

constexpr int kWidth = 3, kHeight = 2;

/// Sums of the samples [begin, end) as a film would hold them, with all of its digits.
FilmSums sumsOf(std::uint64_t begin, std::uint64_t end, bool errorMeter = true) {
  FilmSums sums{kWidth, kHeight, {}, 4096.0};
  sums.begin = begin;
  sums.end = sums.endAhead = end;
  sums.errorMeter = errorMeter;
  std::mt19937 random(unsigned(begin * 1000 + end));
  std::uniform_int_distribution<int> digit(0, (1 << 30) - 1);
  for (const int half : {0, 1}) {
    sums.sums[half].resize(kWidth * kHeight * 3);
    for (FilmSum& sum : sums.sums[half]) sum = {digit(random), digit(random), digit(random) % 100 - 2};
  }
  return sums;
}

PartOrigin origin() {
  PartOrigin out;
  out.scene = "00c0ffee";
  out.version = "1";
  out.project = "room";
  out.devices = {"llvmpipe (LLVM 15)"};
  return out;
}

Part part(std::uint64_t begin, std::uint64_t end) {
  return partOf(sumsOf(begin, end), origin());
}

std::string refusal(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < parts.size(); ++i) names.push_back(std::string(1, char('a' + i)) + ".exr");
  try {
    merged(parts, names);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::badInput);
    return error.what();
  }
  return "merged";
}

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(Part, merges_to_the_same_value_in_any_order_and_grouping) {
  const Part a = part(0, 8), b = part(8, 9), c = part(9, 64);
  const Part all = merged({a, b, c}, {"a", "b", "c"});
  EXPECT_EQ(all, merged({c, a, b}, {"c", "a", "b"}));
  EXPECT_EQ(all, merged({merged({a, b}, {"a", "b"}), c}, {"ab", "c"}));
  EXPECT_EQ(all, merged({a, merged({c, b}, {"c", "b"})}, {"a", "bc"}));
  EXPECT_EQ(all.origin.begin, 0u);
  EXPECT_EQ(all.origin.end, 64u);
}

TEST(Part, keeps_each_layer_of_the_lowest_samples) {
  const auto layer = [](const char* name, float value) {
    return plugins::ImageLayer{
        name, {kWidth, kHeight, 1, std::vector<float>(kWidth * kHeight, value)}, {"Z"}};
  };
  Part a = part(0, 8), b = part(8, 16), c = part(16, 24);
  b.layers = {layer("depth", 2)};
  c.layers = {layer("coverage", 3), layer("depth", 3)};
  const Part all = merged({c, a, b}, {"c", "a", "b"});
  EXPECT_EQ(all.layers, (std::vector{layer("depth", 2), layer("coverage", 3)}));
  EXPECT_EQ(all, merged({a, merged({b, c}, {"b", "c"})}, {"a", "bc"}));
}

TEST(Part, is_the_mean_over_all_samples) {
  const FilmSums a = sumsOf(0, 5), b = sumsOf(5, 12);
  const Image mean = meanOf(merged({partOf(a, origin()), partOf(b, origin())}, {"a", "b"}));
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    long double sum = 0;
    for (const FilmSums* s : {&a, &b})
      for (const int half : {0, 1})
        for (const double term : s->terms(half, i)) sum += term;
    EXPECT_EQ(mean.pixels[i], float(sum / 12.0L)) << i;
  }
}

TEST(Part, survives_its_file) {
  for (const bool meter : {true, false}) {
    const Part written = partOf(sumsOf(4, 11, meter), origin());
    Image file{kWidth, kHeight, 0, {}};
    std::vector<std::string> names{"R", "G", "B"};
    const auto layers = layersOf(written);
    for (const auto& layer : layers)
      for (const auto& channel : layer.channelNames) names.push_back(layer.name + "." + channel);
    file.channels = int(names.size());
    for (int i = 0; i < kWidth * kHeight; ++i) {
      file.pixels.insert(file.pixels.end(), {1, 2, 3});
      for (const auto& layer : layers)
        for (int c = 0; c < 3; ++c) file.pixels.push_back(layer.pixels.pixels[std::size_t(i * 3 + c)]);
    }
    EXPECT_EQ(readPart("a.exr", file, names, partMetadata(written.origin)), written);
  }
}

TEST(Part, knows_its_error_from_the_halves) {
  FilmSums sums = sumsOf(0, 4);
  sums.unit = 2.0;
  for (const int half : {0, 1})
    std::fill(sums.sums[half].begin(), sums.sums[half].end(), FilmSum{0, 0, half == 0 ? 1 : 3});
  const ErrorEstimate error = errorOf(partOf(sums, origin()));  // means 1 and 3: (3 - 1)^2 / 4
  EXPECT_TRUE(error.valid);
  EXPECT_DOUBLE_EQ(error.rmse, 1.0);
  EXPECT_DOUBLE_EQ(error.relRmse, std::sqrt(1.0 / 4.01));
  EXPECT_FALSE(errorOf(partOf(sumsOf(0, 4, false), origin())).valid);
}

TEST(Part, does_not_let_a_lucky_pixel_excuse_its_error) {
  FilmSums sums = sumsOf(0, 4);
  sums.unit = 2.0;  // means are the high digits
  for (const int half : {0, 1}) std::fill(sums.sums[half].begin(), sums.sums[half].end(), FilmSum{0, 0, 1});
  for (int channel = 0; channel < 3; ++channel) sums.sums[1][std::size_t(channel)].high = 101;
  const ErrorEstimate error = errorOf(partOf(sums, origin()));
  // The first pixel's halves are 1 and 101, all around it is 1: an error of 50 over a light of 1
  EXPECT_NEAR(error.relRmse, std::sqrt(2500.0 / 1.01 / (kWidth * kHeight)), 1e-6);
}

TEST(Part, refuses_overlaps_and_gaps_by_name_and_range) {
  EXPECT_TRUE(
      contains(refusal({part(0, 8), part(7, 16)}), "a.exr (0:8) and b.exr (7:16) hold the same samples"));
  EXPECT_TRUE(contains(refusal({part(0, 8), part(0, 8)}), "hold the same samples"));
  EXPECT_TRUE(contains(refusal({part(12, 16), part(0, 8)}),
                       "no part holds the samples 8:12 between b.exr and a.exr"));
}

TEST(Part, refuses_what_is_of_another_picture) {
  Part other = part(8, 16);
  other.origin.scene = "0";
  EXPECT_TRUE(contains(refusal({part(0, 8), other}), "show different scenes"));
  other = part(8, 16);
  other.origin.seed = 5;
  EXPECT_TRUE(contains(refusal({part(0, 8), other}), "have the seeds 0 and 5"));
  other = part(8, 16);
  other.origin.version = "2";
  EXPECT_TRUE(contains(refusal({part(0, 8), other}), "are of Steradian 1 and 2"));
  other = part(8, 16);
  other.width = 2;
  EXPECT_TRUE(contains(refusal({part(0, 8), other}), "differ in size: 3x2 and 2x2"));
  EXPECT_TRUE(contains(refusal({part(0, 8), partOf(sumsOf(8, 16, false), origin())}), "error meter"));
}

TEST(Part, refuses_what_is_not_finite_full_or_unfinished) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Part broken = part(0, 8);
    broken.terms[1][0].pixels[4] = bad;
    EXPECT_TRUE(contains(refusal({broken}), "a.exr: holds values that are not finite"));
  }
  for (const int limit : {1 << 30, -(1 << 30)}) {
    FilmSums full = sumsOf(0, 8);
    full.sums[0][4].high = limit;
    EXPECT_THROW(partOf(full, origin()), Error);
  }
  FilmSums sums = sumsOf(0, 8);
  sums.rowsAhead = 1;
  EXPECT_THROW(partOf(sums, origin()), Error);
}

TEST(Part, refuses_what_lacks_samples_unless_told_to_accept_it) {
  Part holed = part(8, 16);
  holed.origin.nan = 3;
  const std::string reason = refusal({part(0, 8), holed});
  EXPECT_TRUE(contains(reason, "b.exr: its sums lack 3 samples that were not a number")) << reason;
  EXPECT_TRUE(contains(reason, "--accept-nan")) << reason;
  const Part all = merged({part(0, 8), holed}, {"a", "b"}, DroppedSamples::accept);
  EXPECT_EQ(all.origin.nan, 3u) << "the whole says it too, and is refused in its turn";
  EXPECT_EQ(meanOf(all), meanOf(merged({part(0, 8), part(8, 16)}, {"a", "b"})));
}

TEST(Part, tells_why_a_file_is_none) {
  const auto reason = [](std::map<std::string, std::string> metadata, std::vector<std::string> names) {
    try {
      readPart("x.exr", Image{1, 1, int(names.size()), std::vector<float>(names.size())}, names, metadata);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_TRUE(
      contains(reason({}, {"R", "G", "B"}), "x.exr: is no part of a render: it lacks steradian:scene"));
  auto metadata = partMetadata(part(0, 8).origin);
  EXPECT_TRUE(contains(reason(metadata, {"R", "G", "B"}), "it lacks the layer sumA.0"));
  metadata["steradian:samples"] = "8 ";
  EXPECT_TRUE(contains(reason(metadata, {"R", "G", "B"}), "not a whole number"));
}
