// SPDX-License-Identifier: MIT
// steradian render from the outside: files, figures, endings.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "process.hpp"

using namespace process;
using nlohmann::json;

namespace {

json report(const Sandbox& sandbox) {
  return json::parse(contents(sandbox.path("report.json")));
}

Arguments render(const Sandbox& sandbox, const std::string& output, Arguments more) {
  Arguments arguments{"render", project("hello"), "-o",       sandbox.path(output),
                      "--size", "64x48",          "--report", sandbox.path("report.json")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

json compared(const Sandbox& sandbox, const std::string& a, const std::string& b) {
  const Outcome outcome = sandbox.run({"compare", sandbox.path(a), sandbox.path(b), "--json"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  return json::parse(outcome.out);
}

}  // namespace

TEST(Render, works_without_a_display_and_reports_what_it_did) {
  const Sandbox sandbox;
  const Outcome outcome = sandbox.run(render(sandbox, "a.exr", {"--spp", "8"}),
                                      {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"HOME", ""}});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("a.exr: 64x48, 8 samples"), std::string::npos) << outcome.out;
  EXPECT_EQ(contents(sandbox.path("a.exr")).substr(0, 4), "\x76\x2f\x31\x01");
  const json r = report(sandbox);
  EXPECT_EQ(r["spp"], 8);
  EXPECT_EQ(r["width"], 64);
  EXPECT_EQ(r["nan"], 0);
  EXPECT_EQ(r["validationMessages"], 0);
  EXPECT_GE(r["rays"]["closest"].get<double>(), 64.0 * 48.0 * 8.0);
  EXPECT_GT(r["error"]["relRmse"].get<double>(), 0.0);
  EXPECT_EQ(r["memory"], json({{"meshes", 0}, {"textures", 0}, {"sky", 0}}));
  EXPECT_FALSE(r["device"].get<std::string>().empty());
  EXPECT_LE(r["seconds"]["load"].get<double>(), r["seconds"]["firstPixel"].get<double>());
  EXPECT_LE(r["seconds"]["firstPixel"].get<double>(), r["seconds"]["total"].get<double>());
}

TEST(Render, writes_several_formats_from_one_run) {
  const Sandbox sandbox;
  const Outcome outcome = sandbox.run(
      render(sandbox, "a.exr",
             {"-o", sandbox.path("a.png"), "--spp", "2", "--exposure", "1", "--tonemap", "reinhard"}));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(contents(sandbox.path("a.png")).substr(1, 3), "PNG");
  EXPECT_EQ(lines(outcome.out), 2);
}

TEST(Render, until_an_error_stops_near_it) {
  const Sandbox sandbox;
  for (const double target : {0.1, 0.04, 0.02}) {
    const std::string until = "rel=" + std::to_string(target);
    ASSERT_EQ(sandbox.run(render(sandbox, "a.exr", {"--until", until, "--until", "time=60s"})).exitCode, 0);
    const json r = report(sandbox);
    EXPECT_LE(r["error"]["relRmse"].get<double>(), target);
    if (r["samples"]["end"] >= 10)  // one sample more is no tenth
      EXPECT_GT(r["error"]["relRmse"].get<double>(), 0.93 * target) << "far more samples than asked for";
    EXPECT_LT(r["seconds"]["total"].get<double>(), 60.0);
  }
}

TEST(Render, until_a_time_stops_soon_after_it) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.run(render(sandbox, "a.exr", {"--until", "time=1s"})).exitCode, 0);
  const double seconds = report(sandbox)["seconds"]["trace"];
  EXPECT_GE(seconds, 1.0);
  EXPECT_LT(seconds, 3.0);
}

TEST(Render, a_range_of_samples_is_traced_alone) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.run(render(sandbox, "a.exr", {"--samples", "8:12"})).exitCode, 0);
  const json r = report(sandbox);
  EXPECT_EQ(r["spp"], 4);
  EXPECT_EQ(r["samples"], json({{"begin", 8}, {"end", 12}}));
}

TEST(Render, the_same_command_gives_the_same_pixels_and_another_seed_others) {
  const Sandbox sandbox;
  for (const char* name : {"a.exr", "b.exr"})
    ASSERT_EQ(sandbox.run(render(sandbox, name, {"--spp", "4"})).exitCode, 0);
  ASSERT_EQ(sandbox.run(render(sandbox, "c.exr", {"--spp", "4", "--seed", "5"})).exitCode, 0);
  EXPECT_EQ(compared(sandbox, "a.exr", "b.exr")["max"], 0.0);
  const json seeds = compared(sandbox, "a.exr", "c.exr");
  EXPECT_GT(seeds["max"].get<double>(), 0.0);
  EXPECT_NEAR(seeds["meanRatio"][1].get<double>(), 1.0, 0.1);
}

TEST(Render, generic_and_special_pipelines_give_the_same_pixels) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.run(render(sandbox, "a.exr", {"--spp", "4"})).exitCode, 0);
  ASSERT_EQ(sandbox.run(render(sandbox, "b.exr", {"--spp", "4", "--generic"})).exitCode, 0);
  EXPECT_EQ(report(sandbox)["variant"]["specialized"], false);
  EXPECT_EQ(compared(sandbox, "a.exr", "b.exr")["max"], 0.0);
}

TEST(Render, without_the_meter_there_is_no_error_and_none_can_be_asked_for) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.run(render(sandbox, "a.exr", {"--spp", "2", "--no-meter"})).exitCode, 0);
  EXPECT_TRUE(report(sandbox)["error"]["relRmse"].is_null());
  EXPECT_EQ(sandbox.run(render(sandbox, "a.exr", {"--until", "rel=1%", "--no-meter"})).exitCode, 2);
}

TEST(Render, an_image_tells_how_it_was_made) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.run(render(sandbox, "a.exr", {"--spp", "2", "--seed", "7"})).exitCode, 0);
  const Outcome info = sandbox.run({"info", sandbox.path("a.exr"), "--json"});
  ASSERT_EQ(info.exitCode, 0) << info.err;
  const json metadata = json::parse(info.out)["metadata"];
  EXPECT_EQ(metadata["steradian:samples"], "2");
  EXPECT_EQ(metadata["steradian:seed"], "7");
  EXPECT_TRUE(metadata.contains("steradian:relRmse"));
}

TEST(Render, a_full_disk_ends_with_5) {
  const Sandbox sandbox;
  const Outcome outcome = sandbox.run({"render", project("hello"), "-o", sandbox.path("a.exr"), "--size",
                                       "16x16", "--spp", "1", "--report", "/dev/full"});
  EXPECT_EQ(outcome.exitCode, 5) << outcome.err;
}
