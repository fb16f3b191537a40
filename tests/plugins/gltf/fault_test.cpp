// SPDX-License-Identifier: MIT
// Damaged and hostile glTF: one clear line with the place, and the rest loads where it can.
#include <sys/stat.h>

#include "tests/plugins/gltf/maker.hpp"

namespace steradian::plugins {
namespace {

using GltfFault = Gltf;

GltfMaker triangle() {
  GltfMaker maker;
  maker.triangle();
  return maker;
}

TEST_F(GltfFault, fault1_EmptyTruncatedAndForeignFiles) {
  EXPECT_CONTAINS(refusal("", "a.glb"), "is empty");
  EXPECT_CONTAINS(refusal("\x7f"
                          "ELF, certainly no glTF"),
                  "line 1, column 1");
  EXPECT_CONTAINS(refusal("{}"), "asset: expected an object {...}, got nothing");
  const std::string glb = triangle().glb(), text = triangle().text();
  for (std::size_t i = 0; i < 64; ++i) {
    refusal(glb.substr(0, glb.size() * i / 64), "a.glb");
    refusal(text.substr(0, text.size() * i / 64));
  }
  EXPECT_CONTAINS(refusal(glb.substr(0, glb.size() - 4), "a.glb"), "the file is cut short");
}

TEST_F(GltfFault, fault1_AChunkOfNoBytesIsABufferThatIsTooShort) {
  std::string json = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":1}]})";
  while (json.size() % 4) json += ' ';
  const auto word = [](std::size_t value) {
    const auto v = std::uint32_t(value);
    return std::string(reinterpret_cast<const char*>(&v), 4);
  };
  const std::string body = word(json.size()) + "JSON" + json + word(0) + std::string("BIN\0", 4);
  EXPECT_CONTAINS(refusal("glTF" + word(2) + word(12 + body.size()) + body, "a.glb"),
                  "buffers[0].byteLength: expected at most 0, the bytes there are, got 1");
}

TEST_F(GltfFault, fault2_OtherVersionsAreRefused) {
  EXPECT_CONTAINS(refusal(R"({"asset": {"version": "1.0"}, "accessors": {}})"),
                  "asset.version: expected 2.0, got \"1.0\"");
  EXPECT_CONTAINS(refusal(R"({"asset": {"version": "2.0", "minVersion": "2.1"}})"),
                  "asset.minVersion: expected 2.0");
}

TEST_F(GltfFault, fault3_DeepNestingIsRefusedBeforeItIsParsed) {
  for (const std::size_t depth : {61u, 20'000u, 1'000'000u})
    EXPECT_CONTAINS(refusal(R"({"asset": {"version": "2.0"}, "extras": )" + std::string(depth, '[')),
                    "nested deeper than 60");
  EXPECT_EQ(import(R"({"asset": {"version": "2.0"}, "extras": )" + std::string(59, '[') +
                   std::string(59, ']') + "}")
                .scene.objects.size(),
            0u);
}

TEST_F(GltfFault, fault3_WhatIsKeptOfADeepFileStillFitsAProject) {
  GltfMaker maker;
  maker.root({{"name", "n"}});
  std::string text = maker.text();
  text.insert(text.find("\"name\""),
              "\"extras\": {\"a\": " + std::string(56, '[') + std::string(56, ']') + "}, ");
  const Scene scene = import(text).scene;
  ASSERT_FALSE(scene.objects.at(0).extras.empty());
  stockPlugins().exportScene(scene, folder / "a.srad");
  EXPECT_EQ(stockPlugins().importScene(folder / "a.srad").scene.objects, scene.objects);
}

TEST_F(GltfFault, fault5_ByteOrderMarksDuplicateKeysAndInvalidUtf8) {
  EXPECT_EQ(import("\xef\xbb\xbf" + triangle().text()).scene.objects.size(), 1u);
  EXPECT_CONTAINS(refusal("{\"asset\": {\"version\": \"2.0\"}, \"scenes\": [{\"name\": \"\xff\"}]}"),
                  "UTF-8");
  EXPECT_EQ(import(R"({"asset": {"version": "1.0"}, "asset": {"version": "2.0"}})").scene.objects.size(), 0u);
}

TEST_F(GltfFault, WrongTypesNameThePlaceAndWhatWasExpected) {
  const auto says = [&](const char* members) {
    return refusal(std::string(R"({"asset": {"version": "2.0"}, )") + members + "}");
  };
  EXPECT_CONTAINS(says(R"("nodes": {})"), "nodes: expected an array, got {}");
  EXPECT_CONTAINS(says(R"("nodes": [5])"), "nodes[0]: expected an object {...}, got 5");
  EXPECT_CONTAINS(says(R"("nodes": [{"translation": [1, 2]}])"),
                  "nodes[0].translation: expected an array of 3 numbers");
  EXPECT_CONTAINS(says(R"("nodes": [{"mesh": 1}])"),
                  "nodes[0].mesh: expected an index below 0, the number of meshes, got 1");
  EXPECT_CONTAINS(says(R"("nodes": [{"name": 5}])"), "nodes[0].name: expected a text in quotes, got 5");
  EXPECT_CONTAINS(says(R"("scene": "main", "scenes": [{}])"), "scene: expected an index below 1");
  EXPECT_CONTAINS(says(R"("buffers": [{"byteLength": -4}])"),
                  "buffers[0].byteLength: expected a whole number");
  EXPECT_CONTAINS(says(R"("buffers": [{"byteLength": 1e999}])"), "is no sound JSON");
  for (const char* odd : {R"("extensions": {"KHR_lights_punctual": 5})", R"("extensions": 5)",
                          R"("extensions": {"KHR_lights_punctual": {"lights": 5}})"})
    EXPECT_NE(faultOf([&] { import(std::string(R"({"asset": {"version": "2.0"}, )") + odd + "}"); }).second,
              ExitCode::plugin);
}

TEST_F(GltfFault, fault8_CyclesSelfParentsAndSecondParentsAreRefused) {
  const auto says = [&](const char* nodes) {
    return refusal(std::string(R"({"asset": {"version": "2.0"}, "nodes": )") + nodes + "}");
  };
  EXPECT_CONTAINS(says(R"([{"children": [0]}])"),
                  "nodes[0].children[0]: expected another node, got the node itself");
  EXPECT_CONTAINS(says(R"([{"children": [1]}, {"children": [2]}, {"children": [0]}])"),
                  "got a cycle through this one");
  EXPECT_CONTAINS(says(R"([{"children": [2]}, {"children": [2]}, {}])"),
                  "nodes[1].children[0]: expected a node without a parent, got node 2, which is a child of "
                  "node 0 already");
  EXPECT_CONTAINS(says(R"([{"children": [1]}, {}], "scenes": [{"nodes": [1]}])"),
                  "scenes[0].nodes[0]: expected a root node");
}

TEST_F(GltfFault, fault8_AChainOfAHundredThousandNodesIsReadWithoutRecursion) {
  GltfMaker maker;
  Json nodes = Json::array();
  for (int i = 1; i <= 100'000; ++i) nodes.push_back({{"children", {i}}});
  nodes.push_back(Json::object());
  maker.json["nodes"] = nodes;
  maker.json["scenes"][0]["nodes"] = {0};
  EXPECT_EQ(import(maker).scene.objects.size(), 100'001u);
}

/// Two triangles, the first of which `spoil` may damage; gives what the report says of it.
template <class Spoil>
std::string spoiled(Gltf&, GltfMaker& maker, Spoil&& spoil) {
  Json& primitive = maker.triangle();
  primitive["indices"] = maker.accessor<std::uint32_t>({0, 1, 2}, "SCALAR");
  const std::size_t good = maker.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  maker.root({{"name", "good"}, {"mesh", maker.mesh({{"attributes", {{"POSITION", good}}}})}});
  spoil(maker.json);
  return maker.text();
}

TEST_F(GltfFault, fault9_AccessorsThatLeaveTheirBytesCostTheirPrimitiveOnly) {
  struct Case {
    const char* pointer;
    Json value;
    const char* expected;
  };
  const Case cases[] = {
      {"/accessors/0/count", 4, "accessors[0].count: expected at most 3, what its view holds, got 4"},
      {"/accessors/0/count", 1537228672809129302u, "accessors[0].count: expected at most 3"},
      {"/accessors/0/count", 18446744073709549568u, "accessors[0].count: expected at most 3"},
      {"/accessors/0/count", 0, "accessors[0].count: expected a whole number from 1"},
      {"/accessors/0/byteOffset", 18446744073709549568u, "accessors[0].byteOffset: expected at most 36"},
      {"/accessors/0/byteOffset", -4,
       "accessors[0].byteOffset: expected a whole number from 0 to 1.84467e+19, got -4"},
      {"/accessors/0/byteOffset", 1.5, "accessors[0].byteOffset: expected a whole number"},
      {"/accessors/0/componentType", 5130,
       "accessors[0].componentType: expected a whole number from 5120 to 5126"},
      {"/accessors/0/type", "VEC9", "accessors[0].type: expected one of SCALAR VEC2"},
      {"/accessors/0/type", "VEC2 VEC3", "accessors[0].type: expected one of SCALAR VEC2"},
      {"/accessors/0/type", "VEC2", "accessors[0].type: expected 3 to 3 components for POSITION, got 2"},
      {"/accessors/0/bufferView", 99, "accessors[0].bufferView: expected an index below"},
      {"/accessors/0", "text", "accessors[0]: expected an object {...}"},
      {"/bufferViews/0/byteLength", 18446744073709549568u,
       "bufferViews[0]: expected bytes inside its buffer"},
      {"/bufferViews/0/byteOffset", 18446744073709549568u,
       "bufferViews[0]: expected bytes inside its buffer"},
      {"/bufferViews/0/byteStride", 252, "accessors[0].count: expected at most 1"},
      {"/bufferViews/0/byteStride", 8,
       "bufferViews[0].byteStride: expected at least the 12 bytes of an element"},
      {"/bufferViews/0/byteStride", 7,
       "bufferViews[0].byteStride: expected a multiple of 4 from 4 to 252, got 7"},
      {"/meshes/0/primitives/0/attributes/POSITION", 99,
       "meshes[0].primitives[0].attributes.POSITION: expected an index below"},
      {"/meshes/0/primitives/0/mode", 7, "meshes[0].primitives[0].mode: expected a whole number from 0 to 6"},
      {"/meshes/0/primitives/0/indices", 0, "accessors[0].type: expected 1 to 1 components for indices"},
      {"/meshes/0/primitives/0", 5, "meshes[0].primitives[0]: expected an object"},
      {"/meshes/0/primitives/0/attributes", Json::object(),
       "meshes[0].primitives[0].attributes: expected POSITION"},
  };
  for (const Case& c : cases) {
    GltfMaker maker;
    const std::string text =
        spoiled(*this, maker, [&](Json& json) { json[Json::json_pointer(c.pointer)] = c.value; });
    const ImportResult result = import(text);
    EXPECT_CONTAINS(linesOf(result.report), c.expected);
    EXPECT_CONTAINS(linesOf(result.report), "mesh 0: left out: ");
    EXPECT_TRUE(std::holds_alternative<Geometry>(named(result.scene, "good").content)) << c.pointer;
  }
}

TEST_F(GltfFault, fault9_IndicesBeyondTheVerticesAndSparseOnesBeyondTheElements) {
  GltfMaker maker;
  maker.triangle()["indices"] = maker.accessor<std::uint16_t>({0, 1, 3}, "SCALAR");
  EXPECT_CONTAINS(linesOf(import(maker).report),
                  "accessors[0]: expected indices below the 3 vertices, got 3 in element 2");
  for (const auto& [count, index] : {std::pair<int, std::uint16_t>{1, 3}, {4, 0}, {2'000'000'000, 0}}) {
    GltfMaker sparse = triangle();
    sparse.json["accessors"][0]["sparse"] = {
        {"count", count},
        {"indices",
         {{"bufferView", sparse.view(std::vector<std::uint16_t>{index})}, {"componentType", 5123}}},
        {"values", {{"bufferView", sparse.view(std::vector<float>{1, 2, 3})}}}};
    EXPECT_CONTAINS(linesOf(import(sparse).report), "accessors[0].sparse.");
  }
}

TEST_F(GltfFault, fault9_ZerosWithoutBytesDoNotFillTheMemory) {
  GltfMaker maker = triangle();
  maker.json["accessors"][0].erase("bufferView");
  maker.json["accessors"][0]["count"] = 4'000'000'000'000u;
  EXPECT_CONTAINS(linesOf(import(maker).report), "accessors[0].count: expected at most 0");
}

TEST_F(GltfFault, fault6_PositionsThatAreNoNumbersCostTheirPrimitive) {
  for (const float bad : {NAN, INFINITY, 1e30f}) {
    GltfMaker maker = triangle();
    std::memcpy(maker.bytes.data() + 4, &bad, 4);
    EXPECT_CONTAINS(linesOf(import(maker).report),
                    "accessors[0]: expected finite numbers up to 1e12 for POSITION");
  }
}

TEST_F(GltfFault, fault13_NamesThatLeadOutOfTheFolderAreRefused) {
  fs::create_directory(folder / "in");
  writeText(folder / "secret.bin", std::string(64, 'x'));
  fs::create_symlink(folder / "secret.bin", folder / "in/link.bin");
  for (const char* uri :
       {"../secret.bin", "%2e%2e/secret.bin", "..%2Fsecret.bin", "/etc/passwd", "file:///etc/passwd",
        "http://example.org/a.bin", "link.bin", "a/../../secret.bin", "", "%zz", "a%00.bin"}) {
    GltfMaker maker = triangle();
    writeText(folder / "in/a.gltf", maker.text(uri));
    const auto [message, code] = faultOf([&] { stockPlugins().importScene(folder / "in/a.gltf"); });
    EXPECT_EQ(code, ExitCode::badInput) << uri;
    EXPECT_CONTAINS(message, "buffers[0].uri: ");
  }
  GltfMaker maker = triangle();
  writeText(folder / "in/with space.bin", maker.bytes);
  writeText(folder / "in/a.gltf", maker.text("with%20space.bin"));
  EXPECT_EQ(stockPlugins().importScene(folder / "in/a.gltf").scene.objects.size(), 1u);
}

TEST_F(GltfFault, fault14_PipesDevicesAndFoldersAreRefusedAtOnce) {
  ASSERT_EQ(mkfifo((folder / "pipe.bin").c_str(), 0600), 0);
  fs::create_directory(folder / "folder.bin");
  for (const char* uri : {"pipe.bin", "folder.bin"})
    EXPECT_CONTAINS(refusal(triangle().text(uri)), "buffers[0].uri: ");
}

TEST_F(GltfFault, fault15_UnknownRequiredExtensionsAreRefusedByName) {
  GltfMaker maker = triangle();
  maker.json["extensionsRequired"] = {"KHR_mesh_quantization", "VENDOR_magic"};
  EXPECT_CONTAINS(refusal(maker), "without VENDOR_magic, which this importer does not know");
}

TEST_F(GltfFault, fault16_AwkwardNamesWork) {
  for (const char* name : {"mit Leerzeichen.gltf", "日本語.gltf", "new\nline.gltf", "-o.gltf"}) {
    writeText(folder / name, triangle().text());
    EXPECT_EQ(stockPlugins().importScene(folder / name).scene.objects.size(), 1u);
  }
}

TEST_F(GltfFault, BadSkinsCamerasAndLightsAreReportedAndTheRestLoads) {
  GltfMaker maker = triangle();
  maker.append("cameras", {{"type", "perspective"}});
  maker.append("cameras", {{"type", "orthographic"},
                           {"orthographic", {{"xmag", 0}, {"ymag", 0}, {"znear", 0}, {"zfar", 1}}}});
  maker.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "laser"}}};
  maker.root({{"name", "a"}, {"camera", 0}});
  maker.root({{"name", "b"}, {"camera", 1}});
  maker.root({{"name", "c"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  maker.append("skins", {{"joints", {0, 99}}});
  maker.root({{"name", "d"}, {"mesh", 0}, {"skin", 0}});
  const ImportResult result = import(maker);
  EXPECT_EQ(result.scene.objects.size(), 5u);
  EXPECT_CONTAINS(linesOf(result.report),
                  "camera of 'a': left out: cameras[0].perspective: expected an object");
  EXPECT_CONTAINS(linesOf(result.report), "camera of 'b': left out: xmag and ymag");
  EXPECT_CONTAINS(linesOf(result.report),
                  "light of 'c': left out: extensions.KHR_lights_punctual.lights[0].type: expected one of");
  EXPECT_CONTAINS(linesOf(result.report),
                  "mesh of 'd': left out: skins[0].joints[1]: expected an index below 5");
}

}  // namespace
}  // namespace steradian::plugins
