// SPDX-License-Identifier: MIT
// Every kind of geometry that glTF knows arrives as the triangles that it means.
#include "tests/plugins/gltf/maker.hpp"

namespace steradian::plugins {
namespace {

using GltfMesh = Gltf;
using Triangles = std::vector<glm::uvec3>;

const std::vector<float> kFive = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};

Triangles trianglesOf(const ImportResult& result) {
  return onlyMesh(result.scene).triangles;
}

TEST_F(GltfMesh, ATriangleHasItsPositionsAndNoNormals) {
  GltfMaker maker;
  maker.triangle();
  const ImportResult result = import(maker);
  const Mesh& mesh = onlyMesh(result.scene);
  EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_EQ(result.scene.objects.at(0).name, "tri");
  EXPECT_EQ(linesOf(result.report), "");
}

TEST_F(GltfMesh, GlbAndGltfGiveTheSame) {
  GltfMaker maker;
  maker.triangle();
  EXPECT_EQ(onlyMesh(import(maker.glb(), {}, "a.glb").scene).positions,
            onlyMesh(import(maker).scene).positions);
}

TEST_F(GltfMesh, StripsTurnEveryOtherTriangleAndFansShareTheirFirstCorner) {
  for (const auto& [mode, expected] : std::map<int, Triangles>{{5, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}},
                                                               {6, {{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}}}) {
    GltfMaker maker;
    const std::size_t p = maker.positions(kFive);
    maker.root({{"mesh", maker.mesh({{"attributes", {{"POSITION", p}}}, {"mode", mode}})}});
    EXPECT_EQ(trianglesOf(import(maker)), expected) << mode;
  }
}

TEST_F(GltfMesh, IndicesOfAllSizesAreRead) {
  const auto with = [&](auto sample) {
    using Number = decltype(sample);
    GltfMaker maker;
    maker.triangle()["indices"] = maker.accessor(std::vector<Number>{2, 1, 0, 0, 1, 2}, "SCALAR");
    return trianglesOf(import(maker));
  };
  const Triangles expected = {{2, 1, 0}, {0, 1, 2}};
  EXPECT_EQ(with(std::uint8_t()), expected);
  EXPECT_EQ(with(std::uint16_t()), expected);
  EXPECT_EQ(with(std::uint32_t()), expected);
}

TEST_F(GltfMesh, PointsAndLinesAreReportedAndTheRestLoads) {
  for (int mode = 0; mode < 4; ++mode) {
    GltfMaker maker;
    maker.triangle();
    Json other = maker.json["meshes"][0]["primitives"][0];
    other["mode"] = mode;
    maker.json["meshes"][0]["primitives"].push_back(other);
    const ImportResult result = import(maker);
    EXPECT_EQ(result.scene.objects.size(), 1u);
    EXPECT_CONTAINS(linesOf(result.report), "mesh 0, primitive 1: left out: ");
    EXPECT_CONTAINS(linesOf(result.report), mode == 0 ? "points have no surface" : "lines have no surface");
  }
}

TEST_F(GltfMesh, AllAttributesArrive) {
  GltfMaker maker;
  Json& a = maker.triangle()["attributes"];
  a["NORMAL"] = maker.accessor<float>({0, 0, 2, 0, 0, 1, 0, 1, 0}, "VEC3");
  a["TANGENT"] = maker.accessor<float>({1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, 1}, "VEC4");
  a["TEXCOORD_0"] = maker.accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2");
  a["TEXCOORD_1"] = maker.accessor<std::uint8_t>({0, 255, 51, 0, 0, 0}, "VEC2", true);
  a["COLOR_0"] = maker.accessor<std::uint16_t>({65535, 0, 0, 0, 65535, 0, 13107, 0, 0}, "VEC3", true);
  a["_TEMPERATURE"] = maker.accessor<float>({1, 2, 3}, "SCALAR");
  const ImportResult result = import(maker);
  const Mesh& mesh = onlyMesh(result.scene);
  EXPECT_EQ(mesh.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
  EXPECT_EQ(mesh.tangents.at(1), glm::vec4(1, 0, 0, -1));
  EXPECT_EQ(mesh.uv0.at(2), glm::vec2(0, 1));
  EXPECT_EQ(mesh.uv1.at(0), glm::vec2(0, 1));
  EXPECT_FLOAT_EQ(mesh.uv1.at(1).x, 0.2f);
  EXPECT_EQ(mesh.colors.at(0), glm::vec4(1, 0, 0, 1));
  EXPECT_FLOAT_EQ(mesh.colors.at(2).x, 0.2f);
  EXPECT_CONTAINS(linesOf(result.report), "attribute _TEMPERATURE is left out");
}

TEST_F(GltfMesh, QuantizedPositionsAreReadAsNumbers) {
  GltfMaker maker;
  maker.json["extensionsRequired"] = maker.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  Json& a = maker.triangle()["attributes"];
  a["POSITION"] = maker.accessor<std::int16_t>({0, -5, 7, 1, 0, 0, 0, 1, 0}, "VEC3");
  a["NORMAL"] = maker.accessor<std::int8_t>({0, 0, 127, 0, 0, 127, -128, 0, 0}, "VEC3", true);
  const ImportResult result = import(maker);
  EXPECT_EQ(onlyMesh(result.scene).positions.at(0), glm::vec3(0, -5, 7));
  EXPECT_EQ(onlyMesh(result.scene).normals.at(2), glm::vec3(-1, 0, 0));
}

TEST_F(GltfMesh, InterleavedVerticesHonourTheStride) {
  GltfMaker maker;
  Json& a = maker.triangle()["attributes"];
  const std::size_t v = maker.view(std::vector<float>{0, 0, 0, 9, 1, 0, 0, 9, 0, 3, 0, 9});
  maker.json["bufferViews"][v]["byteStride"] = 16;
  a["POSITION"] =
      maker.append("accessors", {{"bufferView", v}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
  EXPECT_EQ(onlyMesh(import(maker).scene).positions.at(2), glm::vec3(0, 3, 0));
}

TEST_F(GltfMesh, SparseAccessorsReplaceElementsAlsoOfNothing) {
  for (const bool onZeros : {false, true}) {
    GltfMaker maker;
    const std::size_t p = maker.triangle()["attributes"]["POSITION"];
    Json& accessor = maker.json["accessors"][p];
    accessor["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", maker.view(std::vector<std::uint16_t>{0, 2})}, {"componentType", 5123}}},
        {"values", {{"bufferView", maker.view(std::vector<float>{7, 8, 9, 4, 5, 6})}}}};
    if (onZeros) maker.json["accessors"][p].erase("bufferView");
    const Mesh mesh = onlyMesh(import(maker).scene);
    EXPECT_EQ(mesh.positions,
              (std::vector<glm::vec3>{{7, 8, 9}, onZeros ? glm::vec3(0) : glm::vec3(1, 0, 0), {4, 5, 6}}));
  }
}

TEST_F(GltfMesh, NormalsWithoutADirectionTakeThatOfAFacet) {
  GltfMaker maker;
  maker.triangle()["attributes"]["NORMAL"] = maker.accessor<float>({0, 1, 0, 0, 0, 0, NAN, 0, 0}, "VEC3");
  const ImportResult result = import(maker);
  EXPECT_EQ(onlyMesh(result.scene).normals, (std::vector<glm::vec3>{{0, 1, 0}, {0, 0, 1}, {0, 0, 1}}));
  EXPECT_CONTAINS(linesOf(result.report), "mesh 0: approximated: 2 normals without a direction");
}

TEST_F(GltfMesh, MorphTargetsAreBakedWithTheWeightsOfTheMeshOrTheNode) {
  GltfMaker maker;
  Json& primitive = maker.triangle();
  primitive["targets"] = {{{"POSITION", maker.accessor<float>({0, 0, 1, 0, 0, 2, 0, 0, 4}, "VEC3")}},
                          {{"POSITION", maker.accessor<float>({8, 0, 0, 8, 0, 0, 8, 0, 0}, "VEC3")}}};
  maker.json["meshes"][0]["weights"] = {0.5, 0.0};
  maker.root({{"name", "other"}, {"mesh", 0}, {"weights", {0.0, 1.0}}});
  const ImportResult result = import(maker);
  EXPECT_EQ(meshOf(named(result.scene, "tri")).positions.at(2), glm::vec3(0, 1, 2));
  EXPECT_EQ(meshOf(named(result.scene, "other")).positions.at(2), glm::vec3(8, 1, 0));
  EXPECT_CONTAINS(linesOf(result.report), "morph targets are baked");
}

TEST_F(GltfMesh, ASkinIsBakedAtTheParameterTime) {
  GltfMaker maker;
  Json& a = maker.triangle()["attributes"];
  a["NORMAL"] = maker.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  a["JOINTS_0"] = maker.accessor<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
  a["WEIGHTS_0"] = maker.accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0}, "VEC4");
  const std::size_t joint = maker.root({{"name", "joint"}});
  const std::size_t still = maker.root({{"name", "still"}, {"translation", {0, 0, 0}}});
  // A skin does not care where its node stands.
  maker.json["nodes"][0]["translation"] = {100, 0, 0};
  maker.json["nodes"][0]["skin"] = maker.append("skins", {{"joints", {joint, still}}});
  const std::size_t times = maker.accessor<float>({0, 2}, "SCALAR");
  const std::size_t moves = maker.accessor<float>({0, 0, 0, 0, 4, 0}, "VEC3");
  maker.append("animations",
               {{"samplers", {{{"input", times}, {"output", moves}}}},
                {"channels", {{{"sampler", 0}, {"target", {{"node", joint}, {"path", "translation"}}}}}}});
  const ImportResult result = import(maker, {{"time", 1.0}});
  const Scene& scene = result.scene;
  const auto mesh = std::find_if(scene.objects.begin(), scene.objects.end(),
                                 [](const Object& o) { return std::holds_alternative<Geometry>(o.content); });
  ASSERT_NE(mesh, scene.objects.end());
  EXPECT_EQ(mesh->parent, Id::none);
  EXPECT_EQ(mesh->transform, Transform{});
  EXPECT_EQ(meshOf(*mesh).positions, (std::vector<glm::vec3>{{0, 2, 0}, {1, 2, 0}, {0, 2, 0}}));
  EXPECT_EQ(scene.animation.channels.size(), 1u);
  EXPECT_CONTAINS(linesOf(result.report), "its skin is baked as it stands at the parameter time");
}

TEST_F(GltfMesh, EqualPrimitivesAreOneMesh) {
  GltfMaker maker;
  maker.triangle();
  maker.root({{"name", "again"}, {"mesh", 0}});
  maker.append("meshes", maker.json["meshes"][0]);
  maker.json["meshes"][1]["primitives"][0]["material"] = maker.append("materials", {{"name", "red"}});
  maker.root({{"name", "red"}, {"mesh", 1}});
  const Scene scene = import(maker).scene;
  EXPECT_EQ(&meshOf(named(scene, "tri")), &meshOf(named(scene, "again")));
  EXPECT_EQ(&meshOf(named(scene, "tri")), &meshOf(named(scene, "red")));
}

}  // namespace
}  // namespace steradian::plugins
