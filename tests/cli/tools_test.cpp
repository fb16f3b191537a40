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
