// SPDX-License-Identifier: MIT
// Files of others: Debian's assimp-testmodels, and random damage. Each is imported or refused with a reason.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>

#include "renderer/scene/validate.hpp"
#include "tests/plugins/meshes/mesh_fixture.hpp"

namespace steradian::plugins {
namespace {

const fs::path kModels = "/usr/share/assimp/models";

TEST(ModelsOfAssimp, AreAllImportedOrRefusedWithAReason) {
  if (!fs::exists(kModels)) GTEST_SKIP() << "Debian's assimp-testmodels is not installed";
  int imported = 0;
  std::vector<std::string> refused;
  for (const auto& entry : fs::recursive_directory_iterator(kModels)) {
    const std::string extension = entry.path().extension();
    if (extension != ".obj" && extension != ".ply") continue;
    try {
      const Scene scene = stockPlugins().importScene(entry.path()).scene;
      EXPECT_TRUE(problemsOf(scene).empty()) << entry.path();
      EXPECT_FALSE(scene.objects.empty()) << entry.path();
      ++imported;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::badInput) << error.what();
      refused.push_back(error.what());
    }
  }
  std::ranges::sort(refused);
  for (const std::string& line : refused) std::printf("refused: %s\n", line.c_str());
  EXPECT_EQ(imported + int(refused.size()), 34);
  EXPECT_EQ(refused.size(), 12u) << "points or lines alone, empty, malformed, UTF-16";
}

/// A small file with everything in it.
struct Seed {
  const char* name;
  std::string bytes;
};

std::vector<Seed> seeds(const fs::path& folder) {
  writeText(
      folder / "m.mtl",
      "newmtl m\nKd 1 0 0\nKs .5 .5 .5\nNs 20\nd 0.5\nmap_Kd -s 1 2 -o 0 1 -clamp on t.png\nKe 1 2 3\n");
  writeText(folder / "t.png", "\x89PNG");
  Scene scene;
  Mesh mesh{.name = "quad",
            .positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
            .triangles = {{0, 1, 2}, {0, 2, 3}}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uv0.assign(4, {0.5f, 0.5f});
  scene.objects = {{.id = Id{1}, .name = "a", .content = Geometry{MeshShape{sharedMesh(mesh)}}}};
  scene.nextId = Id{2};
  stockPlugins().exportScene(scene, folder / "s.srad");
  fs::path asset = fs::directory_iterator(folder / "s.assets")->path();
  std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
      "float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar "
      "int "
      "vertex_indices\nend_header\n";
  binary += std::string(45, '\0') + std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\nproperty "
      "float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\nelement face "
      "2\nproperty list uchar int vertex_indices\nend_header\n";
  for (const char* corner : {"0 0 0", "1 0 0", "1 1 0", "0 1 0"})
    text += std::string(corner) + " 0 0 1 .5 .5\n";
  return {{"a.obj",
           "mtllib m.mtl\no a\nv 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nv .2 .3 0\nvt 0 0\nvt 1 1\nvn 0 0 1\nusemtl "
           "m\ns 1\n"
           "f 1/1/1 2/2/1 3/1/1 4/2/1\nf -1 -2 -3\ng b\nf 1//1 2//1 3//1\nl 1 2\n"},
          {"m.mtl", readText(folder / "m.mtl")},
          {"a.ply", text + "4 0 1 2 3\n3 0 1 2\n"},
          {"b.ply", binary},
          {"s.srad", readText(folder / "s.srad")},
          {"mesh", readText(asset)}};
}

std::string mutated(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n ? random() % n : 0; };
  for (std::size_t edits = 1 + below(4); edits > 0 && !bytes.empty(); --edits) {
    const std::size_t at = below(bytes.size());
    static const char* const tokens[] = {"-1", "99999999999", "4294967295", "nan",  "1e308",
                                         "0",  "/",           "\n",         "\\\n", "f 1 1 1 1 1\n"};
    switch (below(6)) {
      case 0:
        bytes[at] = char(random());
        break;
      case 1:
        bytes[at] = char(bytes[at] ^ (1 << below(8)));
        break;
      case 2:
        bytes.erase(at, 1 + below(20));
        break;
      case 3:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(40)));
        break;
      case 4:
        bytes.insert(at, tokens[below(std::size(tokens))]);
        break;
      default:
        bytes.resize(at);
    }
  }
  return bytes;
}

using MutatedFiles = FolderTest;

TEST_F(MutatedFiles, fault12_NeverCrashHangOrGiveAnUnsoundScene) {
  const std::vector<Seed> all = seeds(folder);
  const fs::path asset = fs::directory_iterator(folder / "s.assets")->path();
  std::mt19937 random(20240607);
  int imported = 0, refused = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(4);
  for (int round = 0; round < 3000 && std::chrono::steady_clock::now() < end; ++round)
    for (const Seed& seed : all) {
      const bool isAsset = seed.name == std::string("mesh"), isLibrary = seed.name == std::string("m.mtl");
      const fs::path changed = isAsset ? asset : folder / seed.name;
      const fs::path opened = isAsset ? folder / "s.srad" : isLibrary ? folder / "a.obj" : changed;
      writeText(changed, mutated(seed.bytes, random));
      try {
        const Scene scene = stockPlugins().importScene(opened).scene;
        ASSERT_TRUE(problemsOf(scene).empty()) << seed.name;
        ++imported;
      } catch (const Error& error) {
        ASSERT_EQ(error.code(), ExitCode::badInput) << error.what() << "\n" << readText(changed);
        ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        ++refused;
      }
      writeText(changed, seed.bytes);
    }
  EXPECT_GT(imported, 50);
  EXPECT_GT(refused, 50);
  std::printf("%d imported, %d refused\n", imported, refused);
}

}  // namespace
}  // namespace steradian::plugins
