// SPDX-License-Identifier: MIT
// Meshes and textures of a project: byte for byte through files beside it, and every damage is named.
#include <cstring>

#include "renderer/scene/validate.hpp"
#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

const Mesh& meshOf(const Object& object) {
  return *std::get<MeshShape>(std::get<Geometry>(object.content).shape).mesh;
}

bool sameContent(const Mesh& a, const Mesh& b) {
  return a.name == b.name && a.positions == b.positions && a.triangles == b.triangles &&
         a.normals == b.normals && a.tangents == b.tangents && a.uv0 == b.uv0 && a.uv1 == b.uv1 &&
         a.colors == b.colors;
}

Mesh quad(const std::string& name, bool attributes) {
  Mesh mesh{.name = name,
            .positions = {{0, 0, 0}, {1, -0.0f, 0}, {1, 1e-42f, 1}, {0, 0.1f, 1e12f}},
            .triangles = {{0, 1, 2}, {0, 2, 3}}};
  if (!attributes) return mesh;
  mesh.normals.assign(4, {0, 1, 0});
  mesh.tangents.assign(4, {1, 0, 0, -1});
  mesh.uv0 = {{0, 0}, {1, 0}, {1, 1}, {0, 1.0f / 3.0f}};
  mesh.uv1.assign(4, {0.25f, -7.5f});
  mesh.colors.assign(4, {1, 0.5f, 0, 1});
  return mesh;
}

std::vector<std::uint8_t> bytesOf(std::string_view text) {
  return {text.begin(), text.end()};
}

class ProjectAssets : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    const auto full = sharedMesh(quad("full", true)), bare = sharedMesh(quad("", false));
    const auto image = std::make_shared<const Texture>(
        Texture{.name = "wood", .encoded = bytesOf(std::string_view("\x89PNG\r\n\x1a\n not\0one", 16))});
    const auto named = std::make_shared<const Texture>(Texture{.name = "far", .file = "maps/far.jpg"});
    Material material{
        .id = Id{1}, .name = "m", .normalScale = 0.5f, .opacity = 0.25f, .alphaMode = AlphaMode::blend};
    material.alphaCutoff = 0.75f, material.thinWalled = true;
    material.albedoTexture = {
        .texture = image, .uvSet = 1, .wrapU = Wrap::clamp, .wrapV = Wrap::mirror, .nearest = true};
    material.albedoTexture.transformX = {2, 0.1f, -1}, material.albedoTexture.transformY = {0, 3, 0.5f};
    material.metallicRoughnessTexture.texture = image;
    material.normalTexture.texture = named, material.emissionTexture.texture = image;
    scene.materials = {material};
    scene.objects = {{.id = Id{2}, .name = "a", .content = Geometry{MeshShape{full}, Id{1}}},
                     {.id = Id{3}, .name = "b", .content = Geometry{MeshShape{bare}}},
                     {.id = Id{4}, .name = "c", .content = Geometry{MeshShape{full}}}};
    scene.nextId = Id{5};
    stockPlugins().exportScene(scene, folder / "room.srad");
  }
  fs::path asset(const std::string& extension) const {
    for (const auto& entry : fs::directory_iterator(folder / "room.assets"))
      if (entry.path().extension() == extension) return entry.path();
    throw std::runtime_error("no " + extension);
  }
  std::string says() {
    const auto [message, code] = faultOf([&] { stockPlugins().importScene(folder / "room.srad"); });
    EXPECT_EQ(code, ExitCode::badInput) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }
  Scene scene;
};

void expectSameAssets(const Scene& loaded, const Scene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    EXPECT_TRUE(sameContent(meshOf(loaded.objects[i]), meshOf(scene.objects[i]))) << i;
  EXPECT_EQ(&meshOf(loaded.objects[0]), &meshOf(loaded.objects[2]))
      << "shared in the scene, shared in the file";
  const Material &m = loaded.materials[0], &was = scene.materials[0];
  EXPECT_EQ(m.albedoTexture.texture->encoded, was.albedoTexture.texture->encoded);
  EXPECT_EQ(m.albedoTexture.texture->name, "wood");
  EXPECT_EQ(m.albedoTexture.texture, m.emissionTexture.texture);
  EXPECT_EQ(m.normalTexture.texture->file, "maps/far.jpg");
  Material equal = m;  // all but the identity of the textures
  equal.albedoTexture.texture = was.albedoTexture.texture;
  equal.metallicRoughnessTexture.texture = was.metallicRoughnessTexture.texture;
  equal.normalTexture.texture = was.normalTexture.texture;
  equal.emissionTexture.texture = was.emissionTexture.texture;
  EXPECT_EQ(equal, was);
}

TEST_F(ProjectAssets, MeshesAndTexturesComeBackByteForByte) {
  const Scene loaded = stockPlugins().importScene(folder / "room.srad").scene;
  expectSameAssets(loaded, scene);
  stockPlugins().exportScene(loaded, folder / "room.srad");
  const std::string first = readText(folder / "room.srad");
  stockPlugins().exportScene(stockPlugins().importScene(folder / "room.srad").scene, folder / "room.srad");
  EXPECT_EQ(readText(folder / "room.srad"), first);
  EXPECT_CONTAINS(first, "\"steradian\": 2");
}

TEST_F(ProjectAssets, EqualContentsShareOneFileAndEveryOtherHasItsOwn) {
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder / "room.assets")) ++files;
  EXPECT_EQ(files, 3u);  // two meshes and one image
}

TEST_F(ProjectAssets, SavedElsewhereTheProjectTakesItsAssetsAlong) {
  const Scene loaded = stockPlugins().importScene(folder / "room.srad").scene;
  fs::create_directory(folder / "else");
  stockPlugins().exportScene(loaded, folder / "else" / "Küche 2.srad");
  fs::remove_all(folder / "room.assets");
  EXPECT_TRUE(fs::exists(folder / "else" / "Küche 2.assets"));
  expectSameAssets(stockPlugins().importScene(folder / "else" / "Küche 2.srad").scene, scene);
}

TEST_F(ProjectAssets, ASceneWithoutThemIsStillVersion1WithoutAFolder) {
  Scene plain;
  plain.objects = {{.id = Id{1}, .content = Geometry{Sphere{}}}};
  plain.nextId = Id{2};
  stockPlugins().exportScene(plain, folder / "plain.srad");
  EXPECT_CONTAINS(readText(folder / "plain.srad"), "\"steradian\": 1");
  EXPECT_FALSE(fs::exists(folder / "plain.assets"));
}

TEST_F(ProjectAssets, UnreferencedAssetsAreLeftAlone) {
  stockPlugins().exportScene(Scene{}, folder / "room.srad");
  EXPECT_TRUE(fs::exists(asset(".mesh")));
}

TEST_F(ProjectAssets, fault10_AMissingTextureIsNamedAndNotFatal) {
  const fs::path png = asset(".png");
  const std::string name = "room.assets/" + png.filename().string();
  fs::remove(png);
  const Scene loaded = stockPlugins().importScene(folder / "room.srad").scene;
  EXPECT_EQ(loaded.materials[0].albedoTexture.texture->file, name);
  stockPlugins().exportScene(loaded, folder / "room.srad");  // still names it
  EXPECT_CONTAINS(readText(folder / "room.srad"), "\"file\": \"" + name + "\"");
}

TEST_F(ProjectAssets, fault1_AMissingOrTruncatedMeshIsAnErrorWithItsPlace) {
  const fs::path mesh = asset(".mesh");
  const std::string whole = readText(mesh);
  for (std::size_t i = 0; i < 32; ++i) {
    writeText(mesh, whole.substr(0, whole.size() * i / 32));
    const std::string message = says();
    EXPECT_CONTAINS(message, "/asset: room.assets/" + mesh.filename().string());
    EXPECT_CONTAINS(message, "room.srad: /meshes/");
  }
  writeText(mesh, whole + "x");
  EXPECT_CONTAINS(says(), "bytes; its counts of ");
  fs::remove(mesh);
  EXPECT_CONTAINS(says(), "No such file");
}

TEST_F(ProjectAssets, fault9_CountsAndIndicesThatDoNotFitAreRefusedBeforeMemoryIsTaken) {
  const fs::path mesh = asset(".mesh");
  const std::string whole = readText(mesh);
  const auto with = [&](std::size_t at, auto value) {
    std::string bytes = whole;
    std::memcpy(bytes.data() + at, &value, sizeof value);
    writeText(mesh, bytes);
    return says();
  };
  EXPECT_CONTAINS(with(8, std::uint32_t(2)), "version 2; this Steradian reads version 1");
  EXPECT_CONTAINS(with(12, std::uint32_t(32)), "attributes that mesh files do not have");
  for (const std::uint64_t count : {std::uint64_t(1) << 32, std::uint64_t(1) << 62, ~std::uint64_t(0)})
    EXPECT_CONTAINS(with(16, count), "more than 2^31");
  EXPECT_CONTAINS(with(24, std::uint64_t(1) << 31), "ask for");
  EXPECT_CONTAINS(with(32 + 48 + 8, std::uint32_t(4)), "has index 4 in triangle 0");
  EXPECT_CONTAINS(with(32, 0x7fc00000u), "not a number");
}

TEST_F(ProjectAssets, fault13_AssetsThatLeadOutOfTheFolderAreRefused) {
  for (const char* name : {"../secret.mesh", "/etc/passwd", "a/../../x.mesh"}) {
    writeText(folder / "room.srad",
              std::string(R"({"steradian": 2, "meshes": [{"id": 1, "asset": ")") + name + "\"}]}");
    EXPECT_CONTAINS(says(), "does not lie inside the folder");
  }
}

TEST_F(ProjectAssets, WrongListsNameTheirPlace) {
  const auto text = [&](const std::string& body) {
    writeText(folder / "room.srad", R"({"steradian": 2, )" + body + "}");
    return says();
  };
  EXPECT_CONTAINS(text(R"("meshes": [{"asset": "a.mesh"}])"), "/meshes/0/id: expected");
  EXPECT_CONTAINS(text(R"("textures": [{"id": 1}, {"id": 1}])"), "texture #1");
  EXPECT_CONTAINS(text(R"("textures": [{"id": 1, "file": "a", "asset": "b"}])"),
                  "/textures/0: expected either");
  EXPECT_CONTAINS(text(R"("objects": [{"id": 1, "mesh": {}}])"), "/objects/0/mesh/id: expected");
  EXPECT_CONTAINS(text(R"("objects": [{"id": 1, "mesh": {"id": 7}}])"), "there is no such mesh");
  EXPECT_CONTAINS(text(R"("materials": [{"id": 1, "albedoTexture": {"texture": 3}}])"),
                  "there is no such texture");
  EXPECT_CONTAINS(text(R"("materials": [{"id": 1, "normalTexture": {"texture": 3, "wrapU": "no"}}])"),
                  "/materials/0/normalTexture/wrapU: expected one of");
}

}  // namespace
}  // namespace steradian::plugins
