// SPDX-License-Identifier: MIT
// Compressed glTF: meshopt and Draco, whole and damaged.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include "tests/plugins/gltf/maker.hpp"

namespace steradian::plugins {
namespace {

using GltfCompression = Gltf;

constexpr float kCorners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 5};
constexpr unsigned kFaces[] = {0, 1, 2, 2, 1, 3};

/// The two triangles, compressed, with the uncompressed buffer left out as gltfpack does.
GltfMaker meshopt() {
  std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(4, 12)),
      faces(meshopt_encodeIndexBufferBound(6, 4));
  vertices.resize(meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), kCorners, 4, 12));
  faces.resize(meshopt_encodeIndexBuffer(faces.data(), faces.size(), kFaces, 6));
  GltfMaker maker;
  maker.json["extensionsRequired"] = maker.json["extensionsUsed"] = {"EXT_meshopt_compression"};
  const auto view = [&](const std::vector<unsigned char>& bytes, int count, int stride, const char* mode) {
    const std::size_t index = maker.view(bytes);
    Json& json = maker.json["bufferViews"][index];
    json["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                     {"byteOffset", json["byteOffset"]},
                                                     {"byteLength", bytes.size()},
                                                     {"byteStride", stride},
                                                     {"count", count},
                                                     {"mode", mode}};
    json["buffer"] = 1;
    json["byteOffset"] = 0;
    json["byteLength"] = count * stride;
    return index;
  };
  const std::size_t p = view(vertices, 4, 12, "ATTRIBUTES"), i = view(faces, 6, 4, "TRIANGLES");
  maker.json["accessors"] = {{{"bufferView", p}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}},
                             {{"bufferView", i}, {"componentType", 5125}, {"count", 6}, {"type", "SCALAR"}}};
  maker.root({{"mesh", maker.mesh({{"attributes", {{"POSITION", 0}}}, {"indices", 1}})}});
  maker.json["buffers"] = {
      {{"byteLength", maker.bytes.size()},
       {"uri", "data:application/octet-stream;base64," + base64(maker.bytes)}},
      {{"byteLength", 1000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  return maker;
}

GltfMaker draco() {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (int f = 0; f < 2; ++f)
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(f), kCorners + 3 * kFaces[3 * f],
                                      kCorners + 3 * kFaces[3 * f + 1], kCorners + 3 * kFaces[3 * f + 2]);
  const auto mesh = builder.Finalize();
  draco::EncoderBuffer buffer;
  draco::Encoder encoder;
  encoder.EncodeMeshToBuffer(*mesh, &buffer);
  GltfMaker maker;
  maker.json["extensionsRequired"] = maker.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  const std::size_t view = maker.view(std::vector<char>(buffer.data(), buffer.data() + buffer.size()));
  // The accessors describe the mesh and have no bytes.
  maker.json["accessors"] = {{{"componentType", 5126}, {"count", mesh->num_points()}, {"type", "VEC3"}},
                             {{"componentType", 5125}, {"count", 6}, {"type", "SCALAR"}}};
  maker.root(
      {{"mesh", maker.mesh({{"attributes", {{"POSITION", 0}}},
                            {"indices", 1},
                            {"extensions",
                             {{"KHR_draco_mesh_compression",
                               {{"bufferView", view},
                                {"attributes", {{"POSITION", mesh->attribute(0)->unique_id()}}}}}}}})}});
  return maker;
}

/// Area and height of the two triangles: whatever order the encoder left them in.
void expectTheTwoTriangles(const Mesh& mesh) {
  ASSERT_EQ(mesh.triangles.size(), 2u);
  float area = 0, height = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
    area += 0.5f * glm::cross(b - a, c - a).z;
    height = std::max({height, a.z, b.z, c.z});
  }
  EXPECT_FLOAT_EQ(area, 1.0f);
  EXPECT_FLOAT_EQ(height, 5.0f);
}

TEST_F(GltfCompression, MeshoptIsDecodedWithoutItsFallbackBuffer) {
  const ImportResult result = import(meshopt());
  ASSERT_EQ(linesOf(result.report), "");
  expectTheTwoTriangles(onlyMesh(result.scene));
}

TEST_F(GltfCompression, MeshoptFiltersGiveUnitNormals) {
  const float normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 0, 0.6f, 0.8f, 0, -1, 0, 0, 0};
  std::vector<std::int8_t> packed(16);
  meshopt_encodeFilterOct(packed.data(), 4, 4, 8, normals);
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(4, 4));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), packed.data(), 4, 4));
  GltfMaker maker = meshopt();
  maker.json.erase("buffers");
  const std::size_t v = maker.view(bytes);
  Json& view = maker.json["bufferViews"][v];
  view["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                   {"byteOffset", view["byteOffset"]},
                                                   {"byteLength", bytes.size()},
                                                   {"byteStride", 4},
                                                   {"count", 4},
                                                   {"mode", "ATTRIBUTES"},
                                                   {"filter", "OCTAHEDRAL"}};
  view["byteStride"] = 4;
  maker.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = maker.append(
      "accessors",
      {{"bufferView", v}, {"componentType", 5120}, {"normalized", true}, {"count", 4}, {"type", "VEC3"}});
  maker.json["buffers"] = {
      {{"byteLength", maker.bytes.size()},
       {"uri", "data:application/octet-stream;base64," + base64(maker.bytes)}},
      {{"byteLength", 1000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  const ImportResult result = import(maker);
  const Mesh& mesh = onlyMesh(result.scene);
  ASSERT_EQ(mesh.normals.size(), 4u) << linesOf(result.report);
  EXPECT_LT(glm::length(mesh.normals[2] - glm::vec3(0, 0.6, 0.8)), 0.02f);
}

TEST_F(GltfCompression, DracoIsDecoded) {
  const ImportResult result = import(draco());
  ASSERT_EQ(linesOf(result.report), "");
  expectTheTwoTriangles(onlyMesh(result.scene));
}

TEST_F(GltfCompression, fault15_DamagedMeshoptAndDracoAreReportedByName) {
  GltfMaker maker = meshopt();
  maker.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["byteLength"] = 5;
  EXPECT_CONTAINS(
      linesOf(import(maker).report),
      "mesh 0: left out: bufferViews[0].extensions.EXT_meshopt_compression: the compressed data are damaged");
  maker = draco();
  maker.json["bufferViews"][0]["byteLength"] = 20;
  EXPECT_CONTAINS(
      linesOf(import(maker).report),
      "mesh 0: left out: meshes[0].primitives[0].extensions.KHR_draco_mesh_compression: Draco says: ");
}

TEST_F(GltfCompression, fault15_ABombIsRefusedBeforeItIsDecoded) {
  GltfMaker maker = meshopt();
  maker.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["count"] = 4'000'000'000u;
  EXPECT_CONTAINS(linesOf(import(maker).report), "4000000000 elements cannot come from");
}

}  // namespace
}  // namespace steradian::plugins
