// SPDX-License-Identifier: MIT
// glTF files that Khronos' validator accepts, and that hold what the scene holds.
#include <sys/wait.h>
#include <array>
#include <cstdio>

#include "renderer/scene/validate.hpp"
#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

using GltfExport = FolderTest;

struct Outcome {
  int status = -1;
  std::string output;
};

Outcome run(const std::string& command) {
  Outcome result;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return result;
  std::array<char, 4096> chunk;
  while (std::size_t n = fread(chunk.data(), 1, chunk.size(), pipe)) result.output.append(chunk.data(), n);
  result.status = WEXITSTATUS(pclose(pipe));
  return result;
}

#define EXPECT_VALID_GLTF(file)                                                                            \
  {                                                                                                        \
    const Outcome verdict = run(std::string("'") + GLTF_VALIDATOR + "' '" + GLTF_VALIDATOR_CACHE + "' '" + \
                                (file).string() + "'");                                                    \
    if (verdict.status == 77) GTEST_SKIP() << verdict.output;                                              \
    EXPECT_EQ(verdict.status, 0) << verdict.output;                                                        \
  }

std::shared_ptr<const Mesh> quad() {
  Mesh mesh{.name = "quad"};
  mesh.positions = {{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.normals.assign(4, {0, 1, 0});
  mesh.tangents.assign(4, {1, 0, 0, 1});
  mesh.uv0 = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  mesh.uv1 = mesh.uv0;
  mesh.colors.assign(4, {1, 0.5f, 0.25f, 1});
  return sharedMesh(std::move(mesh));
}

/// The smallest PNG there is: one grey pixel.
std::vector<std::uint8_t> onePixelPng() {
  static constexpr unsigned char bytes[] = {
      0x89, 'P',  'N',  'G',  '\r', '\n', 0x1a, '\n', 0,    0,    0,    13,   'I',  'H',  'D',  'R',  0,
      0,    0,    1,    0,    0,    0,    1,    8,    0,    0,    0,    0,    0x3a, 0x7e, 0x9b, 0x55, 0,
      0,    0,    10,   'I',  'D',  'A',  'T',  0x78, 0x9c, 0x63, 0x68, 0x00, 0x00, 0x00, 0x82, 0x00, 0x81,
      0x77, 0xcd, 0x72, 0xb6, 0,    0,    0,    0,    'I',  'E',  'N',  'D',  0xae, 0x42, 0x60, 0x82};
  return {std::begin(bytes), std::end(bytes)};
}

Material everyLobe() {
  Material m{.id = Id{1}, .name = "all \"of\" it"};
  m.albedo = {0.1f, 0.7f, 0.3f};
  m.ior = 1.31f;
  m.specular = 0.25f;
  m.emissionColor = {0.2f, 1.0f, 0.9f};
  m.emissionLuminance = 1234.5f;
  m.transmission = 0.5f;
  m.attenuationColor = {0.9f, 0.5f, 0.1f};
  m.attenuationDistance = 0.3f;
  m.clearcoat = 0.75f;
  m.clearcoatRoughness = 0.1f;
  m.edgeTint = {0.9f, 0.8f, 0.7f};
  m.opacity = 0.5f;
  m.alphaMode = AlphaMode::mask;
  m.alphaCutoff = 0.4f;
  const auto texture = std::make_shared<const Texture>(Texture{.name = "grey", .encoded = onePixelPng()});
  m.albedoTexture = {texture, 0, Wrap::mirror, Wrap::clamp, true};
  m.normalTexture = {texture, 1};
  m.emissionTexture = {texture,           0, Wrap::repeat, Wrap::repeat, false, {0.0f, -2.0f, 0.25f},
                       {3.0f, 0.0f, 0.5f}};
  m.metallicRoughnessTexture = {texture};
  return m;
}

/// One object of every kind, in a small tree.
Scene everything() {
  Scene scene{.name = "everything"};
  scene.materials = {everyLobe(), {.id = Id{2}, .name = "plain"}};
  std::uint32_t id = 3;
  const auto add = [&](std::string name, auto content) {
    Object object{.id = Id{id++}, .name = std::move(name)};
    object.transform.translation = {0.1 * id, 1.0 / 3.0, -2.5};
    object.transform.rotation = glm::normalize(glm::dquat(0.9, 0.1, -0.3, 0.2));
    object.transform.scale = {1.5, 1.5, -2.0};
    object.content = std::move(content);
    scene.objects.push_back(std::move(object));
  };
  add("group", Group{});
  for (const Shape& shape : {Shape(Sphere{0.7}), Shape(Plane{}), Shape(Box{{1, 2, 3}}), Shape(Rect{{2, 3}}),
                             Shape(Disk{0.4}), Shape(Cylinder{0.3, 1.7}), Shape(MeshShape{quad()})})
    add("shape " + std::to_string(shape.index()), Geometry{shape, Id{std::uint32_t(1 + shape.index() % 2)}});
  for (const Light& light :
       {Light{PointLight{}, {1, 2, 0.5f}, 33.0f}, Light{SpotLight{0.1f, 0.6f}},
        Light{DirectionalLight{0.0093f}}, Light{SphereLight{0.2}, glm::vec3(1), 100.0f, 3200.0f},
        Light{RectLight{{0.5, 0.25}}}, Light{DiskLight{0.125}},
        Light{EnvironmentLight{.horizon = {0.5f, 0.6f, 0.7f}}}})
    add("light " + std::to_string(light.kind.index()), light);
  add("camera", Camera{.fovY = 0.9, .fNumber = 2.8, .focusDistance = 3.25});
  add("flat camera", Camera{.projection = Projection::orthographic, .orthographicHeight = 4.0});
  for (std::size_t i = 1; i < scene.objects.size(); ++i) scene.objects[i].parent = scene.objects[0].id;
  scene.objects[2].visible = false;
  scene.objects[3].extras = R"({"note":"kept"})";
  scene.animation.channels = {{scene.objects[1].id,
                               Property::translation,
                               Interpolation::cubic,
                               {{0.0, {0, 0, 0, 0}}, {0.7, {1, 2, 3, 0}}, {2.0, {0, 1, 0, 0}}}},
                              {scene.objects[1].id,
                               Property::rotation,
                               Interpolation::linear,
                               {{0.0, {0, 0, 0, 1}}, {1.0, {0, 1, 0, 0}}}},
                              {scene.objects[8].id,
                               Property::lightIntensity,
                               Interpolation::step,
                               {{0.0, {5, 0, 0, 0}}, {1.0, {7, 0, 0, 0}}}}};
  scene.nextId = Id{id};
  return scene;
}

TEST_F(GltfExport, EveryKindOfObjectPassesTheValidatorAsGltf) {
  ASSERT_TRUE(problemsOf(everything()).empty());
  stockPlugins().exportScene(everything(), folder / "all.gltf");
  EXPECT_VALID_GLTF(folder / "all.gltf");
}

TEST_F(GltfExport, EveryKindOfObjectPassesTheValidatorAsGlb) {
  stockPlugins().exportScene(everything(), folder / "all.glb");
  EXPECT_VALID_GLTF(folder / "all.glb");
}

TEST_F(GltfExport, AnEmptySceneIsAValidFile) {
  stockPlugins().exportScene(Scene{}, folder / "empty.gltf");
  EXPECT_VALID_GLTF(folder / "empty.gltf");
}

TEST_F(GltfExport, SharedMeshesAreWrittenOnce) {
  Scene scene;
  const Shape shared = MeshShape{quad()};
  for (std::uint32_t i = 1; i <= 100; ++i)
    scene.objects.push_back({.id = Id{i}, .name = "copy", .content = Geometry{shared}});
  scene.nextId = Id{101};
  stockPlugins().exportScene(scene, folder / "copies.glb");
  EXPECT_LT(fs::file_size(folder / "copies.glb"), 10'000u);
  EXPECT_VALID_GLTF(folder / "copies.glb");
}

TEST_F(GltfExport, TheProjectsOfThisRepositoryPassTheValidator) {
  std::size_t exported = 0;
  for (const auto& entry : fs::directory_iterator(PROJECTS)) {
    if (!entry.is_directory()) continue;
    const fs::path file = folder / (entry.path().filename().string() + ".glb");
    stockPlugins().exportScene(stockPlugins().importScene(entry.path()).scene, file);
    EXPECT_VALID_GLTF(file);
    ++exported;
  }
  EXPECT_GE(exported, 10u);
}

}  // namespace
}  // namespace steradian::plugins
