// SPDX-License-Identifier: MIT
// Mesh files from the outside: info, convert and render take them without a project around them.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "process.hpp"

using namespace process;
using nlohmann::json;

namespace {

/// A quad with a texture that is missing, one material and a line.
std::string quad(const Sandbox& sandbox) {
  std::ofstream(sandbox.path("quad.mtl")) << "newmtl clay\nKd 0.8 0.2 0.1\nPr 0.5\nPm 0\nmap_Kd lost.png\n";
  std::ofstream(sandbox.path("quad.obj"))
      << "mtllib quad.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nvt 0 0\no floor\n"
         "usemtl clay\nf 4/1 3/1 2/1 1/1\nl 1 2\n";
  return sandbox.path("quad.obj");
}

}  // namespace

TEST(Models, info_lists_meshes_and_what_the_import_made_of_the_file) {
  const Sandbox sandbox;
  const Outcome outcome = sandbox.run({"info", quad(sandbox), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  const json info = json::parse(outcome.out);
  ASSERT_EQ(info["meshes"].size(), 1u);
  EXPECT_EQ(info["meshes"][0]["name"], "floor");
  EXPECT_EQ(info["meshes"][0]["triangles"], 2);
  EXPECT_EQ(info["meshes"][0]["vertices"], 4);
  EXPECT_EQ(info["meshes"][0]["attributes"], "uv0");
  EXPECT_EQ(info["objects"]["Mesh"], 1);
  EXPECT_EQ(info["import"]["dropped"].size(), 2u) << info["import"];  // the texture and the line
  EXPECT_NE(sandbox.run({"info", quad(sandbox)}).out.find("triangles: 2"), std::string::npos);
}

TEST(Models, convert_makes_a_project_with_its_assets_beside_it) {
  const Sandbox sandbox;
  std::filesystem::create_directory(sandbox.path("out"));
  ASSERT_EQ(sandbox.run({"convert", quad(sandbox), sandbox.path("out/room.srad")}).exitCode, 0);
  EXPECT_TRUE(std::filesystem::is_directory(sandbox.path("out/room.assets")));
  const Outcome outcome = sandbox.run({"info", sandbox.path("out/room.srad"), "--json"});
  EXPECT_EQ(json::parse(outcome.out)["meshes"][0]["triangles"], 2) << outcome.err;
}

TEST(Models, render_sees_a_model_without_camera_and_light_and_says_how) {
  const Sandbox sandbox;
  const Outcome outcome = sandbox.run({"render", quad(sandbox), "-o", sandbox.path("a.exr"), "--size",
                                       "16x12", "--spp", "4", "--report", sandbox.path("report.json")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("rendered with a camera that sees everything and a soft sky"), std::string::npos)
      << outcome.err;
  const json report = json::parse(contents(sandbox.path("report.json")));
  EXPECT_EQ(report["nan"], 0);
  EXPECT_GE(report["memory"]["meshes"].get<int>(), 16 * (2 + 2 * 3)) << "a node and two triangles";
  const json stats = json::parse(sandbox.run({"info", sandbox.path("a.exr"), "--json"}).out);
  EXPECT_EQ(stats["width"], 16);
}

TEST(Models, fault10_a_missing_texture_of_a_project_is_a_warning) {
  const Sandbox sandbox;
  std::ofstream(sandbox.path("a.srad"))
      << R"({"steradian": 2, "textures": [{"id": 1, "name": "wood", "file": "wood.png"}],
    "materials": [{"id": 1, "albedoTexture": {"texture": 1}}],
    "objects": [{"id": 2, "sphere": {}, "material": 1}, {"id": 3, "pointLight": {}}]})";
  const Outcome outcome = sandbox.run(
      {"render", sandbox.path("a.srad"), "-o", sandbox.path("a.exr"), "--size", "8x8", "--spp", "1"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("texture 'wood' (wood.png)"), std::string::npos) << outcome.err;
  const json info = json::parse(sandbox.run({"info", sandbox.path("a.srad"), "--json"}).out);
  EXPECT_EQ(info["textures"][0]["size"], "missing or damaged");
}
