// SPDX-License-Identifier: MIT
// steradian render --aov: layers in the file, and what is refused before the first sample.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "process.hpp"

using namespace process;
using nlohmann::json;

namespace {

Arguments renderAovs(const Sandbox& sandbox, const std::string& output, Arguments more) {
  Arguments arguments{"render", project("hello"), "-o", sandbox.path(output), "--size", "16x12"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Aovs, all_layers_come_back_by_name) {
  const Sandbox sandbox;
  const Outcome rendered = sandbox.run(renderAovs(sandbox, "a.exr", {"--spp", "4", "--aov", "all"}));
  ASSERT_EQ(rendered.exitCode, 0) << rendered.err;
  const Outcome info = sandbox.run({"info", sandbox.path("a.exr"), "--json"});
  const auto names = json::parse(info.out)["channelNames"].get<std::set<std::string>>();
  const std::set<std::string> expected{
      "R",        "G",       "B",     "albedo.R",   "albedo.G",  "albedo.B",   "normal.X",   "normal.Y",
      "normal.Z", "depth.Z", "id.ID", "coverage.A", "samples.N", "variance.R", "variance.G", "variance.B"};
  EXPECT_EQ(names, expected);
}

TEST(Aovs, what_cannot_be_written_is_refused_at_once) {
  const Sandbox sandbox;
  const auto code = [&](const std::string& file, Arguments more) {
    more.insert(more.end(), {"--spp", "2"});
    return sandbox.run(renderAovs(sandbox, file, more)).exitCode;
  };
  EXPECT_EQ(code("a.exr", {"--aov", "albedo,colour"}), 2);
  EXPECT_EQ(code("a.png", {"--aov", "albedo"}), 2) << "no layers in a PNG";
  EXPECT_EQ(code("a.exr", {"--aov", "variance", "--no-meter"}), 2);
  EXPECT_EQ(code("a.exr", {"--aov", "albedo,variance", "--samples", "0:2"}), 2) << "of the whole film";
  EXPECT_EQ(code("a.exr", {"--aov", "albedo", "--no-meter"}), 0);
}

}  // namespace
