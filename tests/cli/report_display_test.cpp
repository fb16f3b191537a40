// SPDX-License-Identifier: MIT
// The report's SMAPE is of what the scene shows: its exposure and tonemapper count.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "process.hpp"

using namespace process;
using nlohmann::json;

namespace {

/// A lamp over a grey floor.
constexpr const char* kLampOverFloor = R"({"steradian": 1,
  "objects": [
    {"id": 3, "translation": [0, 1, 6], "camera": {"fovY": 0.7}},
    {"id": 4, "plane": {}, "material": 1},
    {"id": 6, "translation": [0, 2, 1], "sphereLight": {"radius": 0.2}}],
  "materials": [{"id": 1, "albedo": [0.5, 0.5, 0.5], "roughness": 1}]})";

double smapeOf(const Sandbox& sandbox, double intensity, double exposure, const std::string& tonemapper) {
  json scene = json::parse(kLampOverFloor);
  scene["objects"][2]["sphereLight"]["intensity"] = intensity;
  scene["display"] = {{"exposure", exposure}, {"tonemapper", "org.steradian.tonemap." + tonemapper}};
  std::ofstream(sandbox.path("lamp.srad")) << scene;
  const Outcome outcome = sandbox.run({"report", sandbox.path("lamp.srad"), "-o", sandbox.path("out"),
                                       "--size", "16x12", "--max-spp", "8", "--seconds", "1", "--runs", "1"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  const json report = json::parse(contents(sandbox.path("out/report.json")));
  return report["scenes"][0]["variants"][0]["points"][0]["smapeDisplay"]["median"];
}

}  // namespace

TEST(ReportCommand, measures_smape_on_the_picture_as_it_is_displayed) {
  const Sandbox sandbox;
  const double smape = smapeOf(sandbox, 8.0, 3.0, "linear");
  ASSERT_GT(smape, 0.0);
  EXPECT_NEAR(smapeOf(sandbox, 64.0, 0.0, "linear"), smape, 1e-5 * smape) << "the same picture is shown";
  EXPECT_GT(std::abs(smapeOf(sandbox, 8.0, 0.0, "linear") - smape), 1e-3 * smape);
  EXPECT_GT(std::abs(smapeOf(sandbox, 8.0, 3.0, "reinhard") - smape), 1e-3 * smape);
}
