// SPDX-License-Identifier: MIT
// Values of options: what is taken and what is refused.
#include "editor/cli/arguments.hpp"

#include <gtest/gtest.h>

#include "renderer/scene/error.hpp"

using namespace steradian;
using namespace steradian::cli;

namespace {
template <class Parse>
void expectUsageError(const char* text, Parse parse) {
  try {
    parse(text);
    ADD_FAILURE() << "'" << text << "' was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos);
  }
}
StillRequest until(std::initializer_list<const char*> texts) {
  StillRequest request;
  for (const char* text : texts) parseUntil(text, request);
  return request;
}
}  // namespace

TEST(Arguments, sizes_are_two_positive_numbers) {
  EXPECT_EQ(parseSize("1280x720"), (Extent{1280, 720}));
  EXPECT_EQ(parseSize("1x16384"), (Extent{1, 16384}));
  for (const char* bad : {"", "x", "1280", "1280x", "x720", "0x10", "-1x10", "1280X720", "16385x1", "1e3x10",
                          "10x10x10", " 10x10", "99999999999x1"})
    expectUsageError(bad, parseSize);
}

TEST(Arguments, sample_ranges_are_not_empty) {
  EXPECT_EQ(parseSampleRange("0:1"), (std::pair<std::uint64_t, std::uint64_t>{0, 1}));
  EXPECT_EQ(parseSampleRange("64:18446744073709551615").second, 18446744073709551615u);
  for (const char* bad : {"", ":", "1:1", "2:1", "-1:4", "1:", ":4", "1-4"})
    expectUsageError(bad, parseSampleRange);
}

TEST(Arguments, until_takes_relative_errors_and_times) {
  EXPECT_DOUBLE_EQ(*until({"rel=1%"}).untilRelRmse, 0.01);
  EXPECT_DOUBLE_EQ(*until({"rel=0.25"}).untilRelRmse, 0.25);
  EXPECT_DOUBLE_EQ(*until({"time=90"}).untilSeconds, 90.0);
  EXPECT_DOUBLE_EQ(*until({"time=1.5m"}).untilSeconds, 90.0);
  EXPECT_DOUBLE_EQ(*until({"time=2h"}).untilSeconds, 7200.0);
}

TEST(Arguments, the_until_that_is_met_first_counts) {
  const StillRequest request = until({"rel=1%", "time=30s", "rel=5%", "time=10s"});
  EXPECT_DOUBLE_EQ(*request.untilRelRmse, 0.05);
  EXPECT_DOUBLE_EQ(*request.untilSeconds, 10.0);
}

TEST(Arguments, until_refuses_what_it_does_not_understand) {
  for (const char* bad : {"", "1%", "rel=", "rel=0", "rel=-1%", "rel=nan", "time=", "time=s", "time=0s",
                          "time=inf", "time=1e99s", "time=9000h", "spp=4", "rel=1%%"})
    expectUsageError(bad, [](const char* text) { until({text}); });
}

TEST(Arguments, what_must_be_above_zero_says_so) {
  for (const char* good : {"1", "0.01", "1e-9"}) EXPECT_EQ(aboveZero(good), "");
  for (const char* bad : {"", "0", "-1", "many", "nan", "inf", "1 "})
    EXPECT_EQ(aboveZero(bad), "'" + std::string(bad) + "' is not valid; expected a number above 0");
}

TEST(Arguments, parameters_are_an_id_and_a_number) {
  EXPECT_EQ(parseParameter("white=4.5"), (std::pair<std::string, double>{"white", 4.5}));
  EXPECT_EQ(parseParameter("dither=false").second, 0.0);
  for (const char* bad : {"", "white", "=4", "white=", "white=much", "white=nan", "white=4 "})
    expectUsageError(bad, parseParameter);
}
