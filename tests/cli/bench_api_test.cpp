// SPDX-License-Identifier: MIT
// bench --api from the outside: one kernel, three APIs, one picture.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "process.hpp"

using namespace process;
using nlohmann::json;

namespace {

/// Rounding leaves 1e-13 and less; a single path that went another way would leave 1e-5.
constexpr double kMostRelMse = 1e-6;

const Arguments kBench{"bench", "--api", "--size", "32x24", "--spp", "4", "--runs", "1", "--json"};

json benched(const Sandbox& sandbox, const std::string& name, const Environment& environment = {}) {
  Arguments arguments = kBench;
  arguments.push_back(project(name));
  const Outcome outcome = sandbox.run(arguments, environment);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  return outcome.exitCode == 0 ? json::parse(outcome.out)[0]["apis"] : json::array();
}

void expectFigures(const json& row) {
  ASSERT_FALSE(row.contains("refused")) << row.dump();
  EXPECT_GT(row["msPerSample"].get<double>(), 0.0) << row.dump();
  EXPECT_GT(row["mraysPerSecond"].get<double>(), 0.0) << row.dump();
  EXPECT_EQ(row["nan"], 0) << row.dump();
  EXPECT_EQ(row["faults"], 0) << row.dump();
  if (row["api"] != "Vulkan") EXPECT_LT(row["relMse"].get<double>(), kMostRelMse) << row.dump();
}

}  // namespace

TEST(BenchApi, all_apis_trace_the_same_picture) {
  const Sandbox sandbox;
  for (const char* name : {"hello", "cornell"}) {
    const json rows = benched(sandbox, name);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0]["api"], "Vulkan");
    EXPECT_EQ(rows[1]["api"], "OpenGL");
    EXPECT_EQ(rows[2]["api"], "C++");
    for (const json& row : rows) expectFigures(row);
  }
}

TEST(BenchApi, without_a_driver_for_opengl_one_line_says_so_and_the_others_run) {
  const Sandbox sandbox;
  const json rows = benched(sandbox, "hello", {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json"}});
  ASSERT_EQ(rows.size(), 3u);
  const std::string refused = rows[1]["refused"];
  EXPECT_NE(refused.find("OpenGL 4.5"), std::string::npos) << refused;
  EXPECT_EQ(lines(refused), 0) << refused;
  expectFigures(rows[0]);
  expectFigures(rows[2]);
}

TEST(BenchApi, without_the_module_one_line_says_so_and_the_others_run) {
  Sandbox sandbox;
  std::filesystem::create_directory(sandbox.path("bin"));
  sandbox.moveBinary(sandbox.path("bin") / "steradian");  // away from lib/
  const json rows = benched(sandbox, "hello");
  ASSERT_EQ(rows.size(), 3u);
  const std::string refused = rows[1]["refused"];
  EXPECT_NE(refused.find("opengl_tracer.so"), std::string::npos) << refused;
  EXPECT_EQ(lines(refused), 0) << refused;
  expectFigures(rows[2]);
}
