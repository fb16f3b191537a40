// SPDX-License-Identifier: MIT
// Help, usage errors and missing things: one clear line and the documented exit code.
#include <gtest/gtest.h>

#include <fstream>

#include "process.hpp"

using namespace process;

namespace {

void expectOneLine(const Outcome& outcome, int exitCode, const std::string& mentions) {
  EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
  EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("steradian: error: ", 0), 0u) << outcome.err;
  EXPECT_NE(outcome.err.find(mentions), std::string::npos) << outcome.err;
  EXPECT_TRUE(outcome.out.empty());
}

}  // namespace

TEST(Usage, help_and_version_are_results) {
  const Sandbox sandbox;
  const Outcome help = sandbox.run({"--help"}), version = sandbox.run({"--version"}),
                render = sandbox.run({"render", "--help"});
  for (const char* subcommand :
       {"edit", "render", "compare", "convert", "info", "devices", "plugins", "bench"})
    EXPECT_NE(help.out.find(subcommand), std::string::npos) << subcommand;
  EXPECT_EQ(version.out.rfind("steradian ", 0), 0u);
  EXPECT_NE(render.out.find("--until"), std::string::npos);
  for (const Outcome& outcome : {help, version, render}) {
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_TRUE(outcome.err.empty());
  }
}

TEST(Usage, mistakes_in_the_command_line_end_with_2) {
  const Sandbox sandbox;
  const std::string hello = project("hello"), out = sandbox.path("a.exr");
  expectOneLine(sandbox.run({"render"}), 2, "input");
  expectOneLine(sandbox.run({"help", "devices"}), 2, "steradian devices --help");
  expectOneLine(sandbox.run({"--device", "0", "devices"}), 2, "before 'devices'");
  expectOneLine(sandbox.run({"render", hello}), 2, "--output");
  expectOneLine(sandbox.run({"render", hello, "-o", out, "--nonsense"}), 2, "--nonsense");
  expectOneLine(sandbox.run({"render", hello, "-o", out, "--spp", "0"}), 2,
                "--spp: '0' is not valid; expected a number above 0");
  expectOneLine(sandbox.run({"render", hello, "-o", out, "--size", "10"}), 2, "--size");
  expectOneLine(sandbox.run({"render", hello, "-o", out, "--until", "soon"}), 2, "--until");
  expectOneLine(sandbox.run({"compare", hello, "--verify-pixel", "1,1", "--json"}), 2, "--verify-pixel");
  expectOneLine(sandbox.run({"render", hello, "-o", out, "--bounces", "65"}), 2, "maxBounces");
  expectOneLine(sandbox.run({"render", hello, "-o", out, "--param", "nonsense=1"}), 2, "nonsense");
  expectOneLine(sandbox.run({"render", hello, "-o", sandbox.path("a.xyz")}), 2, ".exr");
  expectOneLine(sandbox.run({"render", hello, "-o", out, "--frame", "1", "--time", "2"}), 2, "--frame");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Usage, an_input_that_is_not_there_ends_with_3_and_names_it) {
  const Sandbox sandbox;
  const std::string out = sandbox.path("a.exr");
  expectOneLine(sandbox.run({"render", "/nonexistent/room.srad", "-o", out}), 3, "/nonexistent/room.srad");
  expectOneLine(sandbox.run({"info", "/nonexistent/room.srad"}), 3, "/nonexistent/room.srad");
  expectOneLine(sandbox.run({"nosuchcommand"}), 3, "nosuchcommand");
}

TEST(Usage, a_damaged_project_ends_with_3_and_names_the_file) {
  const Sandbox sandbox;
  for (const char* text : {"", "{", "null", "[[[[", "{\"format\": 7}"}) {
    std::ofstream(sandbox.path("bad.srad")) << text;
    expectOneLine(sandbox.run({"render", sandbox.path("bad.srad"), "-o", sandbox.path("a.exr")}), 3,
                  "bad.srad");
  }
}

TEST(Usage, an_unknown_camera_or_tonemapper_names_what_there_is) {
  const Sandbox sandbox;
  expectOneLine(sandbox.run({"render", project("hello"), "-o", sandbox.path("a.exr"), "--camera", "Nobody"}),
                3, "Nobody");
  expectOneLine(sandbox.run({"render", project("hello"), "-o", sandbox.path("a.exr"), "--tonemap", "nope"}),
                3, "org.steradian.tonemap");
}

TEST(Usage, an_output_folder_that_is_not_there_ends_with_5_before_rendering) {
  const Sandbox sandbox;
  expectOneLine(sandbox.run({"render", project("hello"), "-o", sandbox.path("no/such/a.exr")}), 5,
                "does not exist");
}

TEST(Usage, no_vulkan_driver_ends_with_4_and_a_package_to_install) {
  const Sandbox sandbox;
  const Environment none{{"VK_ICD_FILENAMES", "/none.json"}, {"VK_DRIVER_FILES", "/none.json"}};
  for (const Arguments& arguments : {Arguments{"devices"}, Arguments{"render", project("hello"), "-o",
                                                                     sandbox.path("a.exr"), "--spp", "1"}}) {
    const Outcome outcome = sandbox.run(arguments, none);
    EXPECT_EQ(outcome.exitCode, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("mesa-vulkan-drivers"), std::string::npos) << outcome.err;
  }
}

TEST(Usage, a_device_that_is_not_there_ends_with_4) {
  const Sandbox sandbox;
  const Outcome outcome = sandbox.run(
      {"render", project("hello"), "-o", sandbox.path("a.exr"), "--spp", "1", "--device", "Voodoo 2"});
  EXPECT_EQ(outcome.exitCode, 4);
  EXPECT_NE(outcome.err.find("Voodoo 2"), std::string::npos) << outcome.err;
}

TEST(Usage, the_editor_without_a_display_ends_with_4_and_points_to_render) {
  const Sandbox sandbox;
  const Outcome outcome = sandbox.run({project("hello")}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
  EXPECT_EQ(outcome.exitCode, 4);
  EXPECT_NE(outcome.err.find("render"), std::string::npos) << outcome.err;
}
