// SPDX-License-Identifier: MIT
// devices, plugins, info and convert from the outside.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "process.hpp"

using namespace process;
using nlohmann::json;

TEST(Tools, devices_marks_exactly_one_as_chosen) {
  const Sandbox sandbox;
  const Outcome outcome = sandbox.run({"devices", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  int chosen = 0;
  for (const json& device : json::parse(outcome.out)) chosen += device["chosen"].get<bool>();
  EXPECT_EQ(chosen, 1);
  EXPECT_NE(sandbox.run({"devices"}).out.find("* "), std::string::npos);
}

TEST(Tools, plugins_lists_what_was_found_and_names_what_was_not_loaded) {
  const Sandbox sandbox;
  std::filesystem::create_directory(sandbox.path("plugins"));
  std::ofstream(sandbox.path("plugins/broken.so")) << "no library";
  for (const Arguments& arguments :
       {Arguments{"plugins", "--json", "--plugin-path", sandbox.path("plugins")},
        Arguments{"plugins", "list", "--json", "--plugin-path", sandbox.path("plugins")}}) {
    const Outcome outcome = sandbox.run(arguments);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    bool broken = false, exr = false;
    for (const json& file : json::parse(outcome.out)) {
      if (file["path"].get<std::string>().find("broken.so") != std::string::npos)
        broken = !file["loaded"] && !file["reason"].get<std::string>().empty();
      for (const json& contribution : file["contributions"])
        exr = exr || contribution["extensions"] == json::array({".exr"});
    }
    EXPECT_TRUE(broken);
    EXPECT_TRUE(exr);
  }
}

TEST(Tools, info_describes_a_project) {
  const Sandbox sandbox;
  const Outcome outcome = sandbox.run({"info", project("hello"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const json info = json::parse(outcome.out);
  EXPECT_EQ(info["kind"], "scene");
  EXPECT_FALSE(info["objects"].empty());
}

TEST(Tools, convert_writes_a_project_that_reads_back_the_same) {
  const Sandbox sandbox;
  for (const auto& [from, to] : {std::pair(project("hello"), sandbox.path("a.srad")),
                                 std::pair(sandbox.path("a.srad").string(), sandbox.path("b.srad"))}) {
    const Outcome outcome = sandbox.run({"convert", from, to});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  }
  EXPECT_EQ(contents(sandbox.path("a.srad")), contents(sandbox.path("b.srad")));
  EXPECT_EQ(sandbox.run({"convert", project("hello"), sandbox.path("a.xyz")}).exitCode, 2);
}

TEST(Tools, every_shipped_project_opens_with_all_it_names) {
  const Sandbox sandbox;
  int projects = 0;
  for (const auto& folder : std::filesystem::directory_iterator(STERADIAN_PROJECTS)) {
    const Outcome outcome = sandbox.run({"info", "--json", folder.path()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "README.md")) << folder.path();
    for (const auto& [file, size] : json::parse(outcome.out)["images"].items())
      EXPECT_NE(size, "missing") << file;
    ++projects;
  }
  EXPECT_GE(projects, 11);
}

TEST(Tools, a_missing_sky_is_a_warning_for_info_and_ends_render_with_3) {
  const Sandbox sandbox;
  std::ofstream(sandbox.path("a.srad"))
      << R"({"steradian": 1, "objects": [{"name": "Sky", "environmentLight": {"file": "lost.exr"}}]})";
  const Outcome info = sandbox.run({"info", "--json", sandbox.path("a.srad")});
  EXPECT_EQ(info.exitCode, 0);
  EXPECT_EQ(json::parse(info.out)["images"]["lost.exr"], "missing");
  EXPECT_NE(info.err.find("lost.exr"), std::string::npos) << info.err;
  const Outcome render = sandbox.run({"render", sandbox.path("a.srad"), "-o", sandbox.path("a.exr")});
  EXPECT_EQ(render.exitCode, 3);
  EXPECT_EQ(lines(render.err), 1) << render.err;
  EXPECT_NE(render.err.find("lost.exr"), std::string::npos) << render.err;
  EXPECT_FALSE(std::filesystem::exists(sandbox.path("a.exr")));
}

TEST(Tools, convert_names_a_sky_from_the_new_place) {
  const Sandbox sandbox;
  const Outcome outcome = sandbox.run({"convert", project("sky"), sandbox.path("a.srad")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(sandbox.run({"info", sandbox.path("a.srad")}).err, "");
}

TEST(Tools, results_that_cannot_be_written_end_with_5) {
  const std::string command = std::string("'") + STERADIAN_BINARY + "' plugins > /dev/full 2> /dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 5);
}

TEST(Tools, compare_refuses_what_is_no_image) {
  const Sandbox sandbox;
  std::ofstream(sandbox.path("a.exr")) << "not an image";
  std::ofstream(sandbox.path("b.exr")) << "\x76\x2f\x31\x01 and then nothing of use";
  for (const char* name : {"a.exr", "b.exr", "missing.exr"}) {
    const Outcome outcome = sandbox.run({"compare", sandbox.path(name), sandbox.path(name)});
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
  }
}
