// SPDX-License-Identifier: MIT
// What clamping takes from a picture is told, and it is what is missing.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "process.hpp"

using namespace process;
using nlohmann::json;

namespace {

/// A lamp over a grey floor beside a metal ball that throws its light about. Everything is grey, so that each
/// channel loses what the luminance loses.
constexpr const char* kMetalBall = R"({"steradian": 1,
  "render": {"width": 48, "height": 32, "maxBounces": 4, "clamp": 0},
  "materials": [
    {"id": 1, "albedo": [0.8, 0.8, 0.8], "roughness": 1},
    {"id": 2, "albedo": [0.9, 0.9, 0.9], "metallic": 1, "roughness": 0.2}],
  "objects": [
    {"id": 3, "translation": [0, 1, 6], "camera": {"fovY": 0.7}},
    {"id": 4, "plane": {}, "material": 1},
    {"id": 5, "translation": [-1, 1, 0], "sphere": {"radius": 1}, "material": 2},
    {"id": 6, "translation": [1.5, 1.5, 0.5], "sphereLight": {"radius": 0.2, "intensity": 100}}]})";

struct Render {
  json report;
  std::string warnings;
};
Render rendered(const Sandbox& sandbox, const std::string& name, double clamp, const Arguments& more = {}) {
  json scene = json::parse(kMetalBall);
  scene["render"]["clamp"] = clamp;
  std::ofstream(sandbox.path(name + ".srad")) << scene;
  Arguments arguments{
      "render",   sandbox.path(name + ".srad"), "-o", sandbox.path(name + ".exr"), "--spp", "32", "--generic",
      "--report", sandbox.path(name + ".json")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = sandbox.run(arguments);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  return {json::parse(contents(sandbox.path(name + ".json"))), outcome.err};
}

/// How much darker the first picture is than the second.
double missing(const Sandbox& sandbox, const std::string& a, const std::string& b) {
  const Outcome outcome =
      sandbox.run({"compare", sandbox.path(a + ".exr"), sandbox.path(b + ".exr"), "--json"});
  return 1.0 - json::parse(outcome.out)["meanRatio"][1].get<double>();
}

}  // namespace

TEST(Clamp, tells_the_share_of_the_light_that_it_removed) {
  const Sandbox sandbox;
  const Render whole = rendered(sandbox, "whole", 0.0);
  EXPECT_TRUE(whole.report["clampedShare"].is_null());
  EXPECT_EQ(whole.warnings.find("clamp"), std::string::npos) << whole.warnings;
  for (const double clamp : {0.02, 1.0}) {
    const Render cut = rendered(sandbox, "cut", clamp);
    // The same paths, so nothing but the clamp makes the difference.
    const double share = cut.report["clampedShare"];
    EXPECT_GT(share, 0.0);
    EXPECT_NEAR(share, missing(sandbox, "cut", "whole"), 1e-3 * share + 1e-6) << "clamp at " << clamp;
    EXPECT_NE(cut.warnings.find("warning: the clamp removed"), std::string::npos) << cut.warnings;
    EXPECT_NE(cut.warnings.find(" % of the light"), std::string::npos) << cut.warnings;
  }
}

TEST(Clamp, share_needs_no_error_meter) {
  const Sandbox sandbox;
  rendered(sandbox, "whole", 0.0, {"--no-meter"});
  const double share = rendered(sandbox, "cut", 1.0, {"--no-meter"}).report["clampedShare"];
  EXPECT_GT(share, 0.0);
  EXPECT_NEAR(share, missing(sandbox, "cut", "whole"), 1e-3 * share + 1e-6);
}

TEST(Clamp, that_cuts_nothing_says_zero_and_warns_of_nothing) {
  const Sandbox sandbox;
  const Render high = rendered(sandbox, "high", 1e9);
  EXPECT_EQ(high.report["clampedShare"].get<double>(), 0.0);
  EXPECT_EQ(high.warnings.find("clamp"), std::string::npos) << high.warnings;
}
