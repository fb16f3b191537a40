// SPDX-License-Identifier: MIT
// steradian merge, compare and report from the outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "process.hpp"

using namespace process;
using nlohmann::json;

namespace {

void renderPart(const Sandbox& sandbox, const std::string& samples, const std::string& name,
                Arguments more = {}) {
  Arguments arguments{"render",    project("hello"), "--size", "32x24",
                      "--samples", samples,          "-o",     sandbox.path(name)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = sandbox.run(arguments);
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
}

Outcome merge(const Sandbox& sandbox, const std::vector<std::string>& parts, const std::string& output) {
  Arguments arguments{"merge"};
  for (const std::string& part : parts) arguments.push_back(sandbox.path(part));
  arguments.insert(arguments.end(), {"-o", sandbox.path(output)});
  return sandbox.run(arguments);
}

}  // namespace

TEST(Merge, of_two_halves_is_the_whole_in_any_order_and_grouping) {
  const Sandbox sandbox;
  renderPart(sandbox, "0:8", "a.exr");
  renderPart(sandbox, "8:13", "b.exr");
  renderPart(sandbox, "13:16", "c.exr");
  renderPart(sandbox, "0:16", "whole.exr");
  ASSERT_EQ(merge(sandbox, {"a.exr", "b.exr", "c.exr"}, "abc.exr").exitCode, 0);
  ASSERT_EQ(merge(sandbox, {"c.exr", "a.exr", "b.exr"}, "cab.exr").exitCode, 0);
  ASSERT_EQ(merge(sandbox, {"b.exr", "c.exr"}, "bc.exr").exitCode, 0);
  ASSERT_EQ(merge(sandbox, {"bc.exr", "a.exr"}, "bc_a.exr").exitCode, 0);
  const std::string bytes = contents(sandbox.path("abc.exr"));
  EXPECT_FALSE(bytes.empty());
  EXPECT_EQ(contents(sandbox.path("cab.exr")), bytes);
  EXPECT_EQ(contents(sandbox.path("bc_a.exr")), bytes);
  EXPECT_EQ(contents(sandbox.path("whole.exr")), bytes);
}

TEST(Merge, of_thousands_of_samples_in_glass_is_the_whole) {
  const Sandbox sandbox;
  for (const auto& [samples, name] :
       {std::pair("0:2000", "whole.exr"), std::pair("0:633", "a.exr"), std::pair("633:2000", "b.exr")}) {
    const Outcome outcome = sandbox.run(
        {"render", project("glass"), "--size", "16x12", "--samples", samples, "-o", sandbox.path(name)});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  }
  ASSERT_EQ(merge(sandbox, {"a.exr", "b.exr"}, "ab.exr").exitCode, 0);
  EXPECT_TRUE(contents(sandbox.path("ab.exr")) == contents(sandbox.path("whole.exr")));
}

TEST(Merge, of_parts_is_the_picture_of_one_render) {
  const Sandbox sandbox;
  const auto projects = {"hello", "cornell"};
  for (const char* name : projects) {
    SCOPED_TRACE(name);
    const auto render = [&](Arguments range, const std::string& output) {
      Arguments arguments{"render", project(name), "--size", "24x18", "-o", sandbox.path(output)};
      arguments.insert(arguments.end(), range.begin(), range.end());
      ASSERT_EQ(sandbox.run(arguments).exitCode, 0);
    };
    render({"--samples", "0:11"}, "a.exr");
    render({"--samples", "11:37"}, "b.exr");
    render({"--spp", "37"}, "whole.exr");
    ASSERT_EQ(merge(sandbox, {"a.exr", "b.exr"}, "ab.exr").exitCode, 0);
    const Outcome compared =
        sandbox.run({"compare", sandbox.path("ab.exr"), sandbox.path("whole.exr"), "--fail-above", "rmse=0"});
    EXPECT_EQ(compared.exitCode, 0) << compared.out;
  }
}

TEST(Merge, keeps_the_layers_of_camera_rays) {
  const Sandbox sandbox;
  renderPart(sandbox, "0:4", "a.exr", {"--aov", "albedo,id"});
  renderPart(sandbox, "4:8", "b.exr", {"--aov", "all"});
  renderPart(sandbox, "8:12", "c.exr");
  ASSERT_EQ(merge(sandbox, {"c.exr", "b.exr", "a.exr"}, "whole.exr").exitCode, 0);
  ASSERT_EQ(merge(sandbox, {"b.exr", "c.exr"}, "bc.exr").exitCode, 0);
  ASSERT_EQ(merge(sandbox, {"a.exr", "bc.exr"}, "again.exr").exitCode, 0);
  EXPECT_EQ(contents(sandbox.path("again.exr")), contents(sandbox.path("whole.exr")));
  const Outcome info = sandbox.run({"info", sandbox.path("whole.exr"), "--json"});
  const auto names = json::parse(info.out)["channelNames"].get<std::vector<std::string>>();
  for (const char* name : {"albedo.R", "normal.Z", "depth.Z", "id.ID", "coverage.A"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  EXPECT_EQ(std::count(names.begin(), names.end(), "variance.R"), 0);
}

TEST(Merge, refuses_overlaps_gaps_other_scenes_and_pictures_that_are_no_parts) {
  const Sandbox sandbox;
  renderPart(sandbox, "0:4", "a.exr");
  renderPart(sandbox, "2:6", "overlap.exr");
  renderPart(sandbox, "6:8", "gap.exr");
  renderPart(sandbox, "4:8", "seed.exr", {"--seed", "3"});
  renderPart(sandbox, "4:8", "bounces.exr", {"--bounces", "1"});
  ASSERT_EQ(sandbox
                .run({"render", project("hello"), "--size", "32x24", "--spp", "4", "-o",
                      sandbox.path("picture.exr")})
                .exitCode,
            0);
  const std::pair<const char*, const char*> refusals[] = {{"overlap.exr", "hold the same samples"},
                                                          {"gap.exr", "no part holds the samples 4:6"},
                                                          {"seed.exr", "have the seeds 0 and 3"},
                                                          {"bounces.exr", "show different scenes"},
                                                          {"picture.exr", "is no part of a render"}};
  for (const auto& [name, reason] : refusals) {
    const Outcome outcome = merge(sandbox, {"a.exr", name}, "out.exr");
    EXPECT_EQ(outcome.exitCode, 3) << name;
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(sandbox.path("out.exr")));
  }
  EXPECT_EQ(merge(sandbox, {"a.exr"}, "out.png").exitCode, 2);
}

TEST(Merge, refuses_a_part_that_lacks_samples_unless_told_to_accept_it) {
  const Sandbox sandbox;
  renderPart(sandbox, "0:4", "a.exr");
  renderPart(sandbox, "4:8", "b.exr");
  std::string bytes = contents(sandbox.path("b.exr"));
  const std::string count("steradian:nan\0string\0\1\0\0\0",
                          25);  // an attribute of OpenEXR: then its one digit
  ASSERT_NE(bytes.find(count), std::string::npos);
  bytes[bytes.find(count) + count.size()] = '3';
  std::ofstream(sandbox.path("b.exr"), std::ios::binary) << bytes;
  const Outcome refused = merge(sandbox, {"b.exr", "a.exr"}, "out.exr");
  EXPECT_EQ(refused.exitCode, 3);
  EXPECT_NE(refused.err.find("b.exr: its sums lack 3 samples"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(sandbox.path("out.exr")));
  const Outcome accepted = sandbox.run(
      {"merge", "--accept-nan", sandbox.path("a.exr"), sandbox.path("b.exr"), "-o", sandbox.path("out.exr")});
  EXPECT_EQ(accepted.exitCode, 0) << accepted.err;
  EXPECT_NE(accepted.err.find("3 samples were not a number"), std::string::npos) << accepted.err;
}

TEST(Compare, fails_above_a_limit_and_only_there) {
  const Sandbox sandbox;
  renderPart(sandbox, "0:2", "a.exr");
  renderPart(sandbox, "2:4", "b.exr");
  const auto compare = [&](const std::string& limit) {
    return sandbox.run(
        {"compare", sandbox.path("a.exr"), sandbox.path("b.exr"), "--json", "--fail-above", limit});
  };
  const Outcome within = compare("relRmse=10");
  EXPECT_EQ(within.exitCode, 0) << within.err;
  EXPECT_GT(json::parse(within.out)["smapeDisplay"].get<double>(), 0.0);
  const Outcome above = compare("relRmse=1e-9");
  EXPECT_EQ(above.exitCode, 1);
  EXPECT_NE(above.err.find("relRmse is "), std::string::npos) << above.err;
  EXPECT_EQ(compare("beauty=1").exitCode, 2);
}

TEST(ReportCommand, measures_a_scene_with_its_features_switched_off) {
  const Sandbox sandbox;
  const Outcome outcome =
      sandbox.run({"report", project("hello"), "-o", sandbox.path("out"), "--size", "16x12", "--max-spp", "8",
                   "--seconds", "3", "--runs", "2", "--ablate"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const json scene = json::parse(contents(sandbox.path("out/report.json")))["scenes"][0];
  EXPECT_EQ(scene["reference"]["samples"], 512);
  std::vector<std::string> ids;
  for (const json& variant : scene["variants"]) {
    ids.push_back(variant["id"]);
    EXPECT_EQ(variant["points"].size(), 4u);
    EXPECT_EQ(variant["nan"], 0);
    const auto error = [&](int point) { return variant["points"][point]["relRmse"]["median"].get<double>(); };
    EXPECT_LT(error(3), error(0)) << variant["id"];
    EXPECT_TRUE(variant["slopeOverSamples"].is_number()) << variant["id"];
  }
  EXPECT_EQ(ids.front(), "full");
  EXPECT_LT(scene["variants"][0]["slopeOverSamples"].get<double>(), -0.4);
  EXPECT_NE(std::find(ids.begin(), ids.end(), "independent-samples"), ids.end());
  EXPECT_NE(std::find(ids.begin(), ids.end(), "generic"), ids.end());
  EXPECT_NE(contents(sandbox.path("out/report.md")).find("hello.svg"), std::string::npos);
  EXPECT_NE(contents(sandbox.path("out/hello.svg")).find("</svg>"), std::string::npos);
}

TEST(ReportCommand, measures_every_scene_on_every_device) {
  const Sandbox sandbox;
  const Outcome outcome =
      sandbox.run({"report", project("hello"), "-o", sandbox.path("out"), "--size", "16x12", "--max-spp", "8",
                   "--seconds", "1", "--runs", "1", "--device", "0", "--device", "0"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const json scenes = json::parse(contents(sandbox.path("out/report.json")))["scenes"];
  ASSERT_EQ(scenes.size(), 2u);
  EXPECT_EQ(scenes[0]["device"], scenes[1]["device"]);
  EXPECT_FALSE(scenes[0]["device"].get<std::string>().empty());
  EXPECT_TRUE(scenes[0]["relMseToFirstDevice"].is_null());
  EXPECT_EQ(scenes[1]["relMseToFirstDevice"], 0.0) << "the same device gives the same bytes";
  EXPECT_NE(contents(sandbox.path("out/report.md")).find("on the first device: relMSE 0"), std::string::npos);
  EXPECT_NE(contents(sandbox.path("out/hello-2.svg")).find("</svg>"), std::string::npos);
  EXPECT_EQ(sandbox.run({"report", project("hello"), "--device", "no such"}).exitCode, 4);
}
