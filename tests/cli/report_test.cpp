// SPDX-License-Identifier: MIT
// The keys of --report are a promise to programs.
#include "editor/cli/render_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "renderer/scene/error.hpp"

using namespace steradian;
using namespace steradian::cli;

TEST(Report, has_exactly_the_documented_keys) {
  RenderReport report;
  report.stats.error.valid = true;
  const auto json = nlohmann::json::parse(reportText(report));
  const auto keys = [](const nlohmann::json& object) {
    std::set<std::string> names;
    for (const auto& [name, value] : object.items()) names.insert(name);
    return names;
  };
  EXPECT_EQ(keys(json),
            (std::set<std::string>{"device", "driver", "queues", "width", "height", "spp", "samples",
                                   "seconds", "rays", "memory", "mraysPerSecond", "error", "nan",
                                   "clampedShare", "variant", "validationMessages"}));
  EXPECT_EQ(keys(json["seconds"]),
            (std::set<std::string>{"load", "compile", "firstPixel", "trace", "total"}));
  EXPECT_EQ(keys(json["rays"]), (std::set<std::string>{"closest", "shadow"}));
  EXPECT_EQ(keys(json["error"]), (std::set<std::string>{"rmse", "relRmse", "slope", "tails"}));
  EXPECT_EQ(keys(json["error"]["tails"]), (std::set<std::string>{"share", "pixels", "heavy"}));
  EXPECT_EQ(keys(json["variant"]), (std::set<std::string>{"specialized", "features", "leftOut"}));
}

TEST(Report, counts_rays_per_second_of_tracing_and_has_no_error_without_a_meter) {
  RenderReport report;
  report.stats.raysClosest = 3'000'000;
  report.stats.raysShadow = 1'000'000;
  report.traceSeconds = 2.0;
  const auto json = nlohmann::json::parse(reportText(report));
  EXPECT_DOUBLE_EQ(json["mraysPerSecond"], 2.0);
  EXPECT_TRUE(json["error"]["rmse"].is_null());
}

TEST(Report, that_cannot_be_written_is_an_error_of_files) {
  try {
    writeReport({}, "/nonexistent/report.json");
    FAIL() << "expected an Error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::io);
  }
  EXPECT_THROW(writeReport({}, "/dev/full"), Error);
}
