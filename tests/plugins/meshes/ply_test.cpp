// SPDX-License-Identifier: MIT
// PLY in all three encodings, and every way in which its counts may lie.
#include <algorithm>
#include <cstring>

#include "tests/plugins/meshes/mesh_fixture.hpp"

namespace steradian::plugins {
namespace {

class PlyFile : public MeshFileTest {
 protected:
  PlyFile() : MeshFileTest("a.ply") {}

  static std::string header(const std::string& format, const std::string& rest) {
    return "ply\nformat " + format + " 1.0\ncomment hello\n" + rest + "end_header\n";
  }
};

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kTriangle =
    "element vertex 3\n" + kXyz + "element face 1\nproperty list uchar int vertex_indices\n";

template <class Number>
std::string bytesOf(Number value, bool big) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (big) std::reverse(bytes, bytes + sizeof value);
  return {bytes, sizeof value};
}

TEST_F(PlyFile, TextAndBothByteOrdersGiveTheSameMesh) {
  const std::string properties =
      "element vertex 4\nproperty double x\nproperty float y\nproperty short z\nproperty float nx\nproperty "
      "float ny\n"
      "property float nz\nproperty float s\nproperty float t\nproperty uchar red\nproperty uchar "
      "green\nproperty uchar "
      "blue\nproperty ushort alpha\nelement face 2\nproperty uchar flags\nproperty list ushort uint "
      "vertex_index\n";
  const double x[] = {0, 1, 1, 0};
  const float y[] = {0, 0, 1, 1};
  std::string text = header("ascii", properties), little = header("binary_little_endian", properties),
              big = header("binary_big_endian", properties);
  for (int i = 0; i < 4; ++i) {
    text += std::to_string(x[i]) + " " + std::to_string(y[i]) + " -7 0 0 2 0.25 0.75 255 0 128 65535\n";
    for (std::string* out : {&little, &big}) {
      const bool b = out == &big;
      *out += bytesOf(x[i], b) + bytesOf(y[i], b) + bytesOf(std::int16_t(-7), b);
      for (const float f : {0.0f, 0.0f, 2.0f, 0.25f, 0.75f}) *out += bytesOf(f, b);
      *out += "\xff" + std::string(1, 0) + "\x80" + bytesOf(std::uint16_t(65535), b);
    }
  }
  text += "9 4 0 1 2 3\n9 2 0 1";
  for (std::string* out : {&little, &big}) {
    const bool b = out == &big;
    *out += "\x09" + bytesOf(std::uint16_t(4), b);
    for (std::uint32_t i = 0; i < 4; ++i) *out += bytesOf(i, b);
    *out += "\x09" + bytesOf(std::uint16_t(2), b) + bytesOf(0u, b) + bytesOf(1u, b);
  }
  for (const std::string& bytes : {text, little, big}) {
    const Scene scene = read(bytes);
    const Mesh& mesh = meshOf(scene, 0);
    EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, -7}, {1, 0, -7}, {1, 1, -7}, {0, 1, -7}}));
    EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(4, {0, 0, 1}));
    EXPECT_EQ(mesh.uv0, std::vector<glm::vec2>(4, {0.25f, 0.25f}));
    ASSERT_EQ(mesh.colors.size(), 4u);
    EXPECT_EQ(mesh.colors[0].r, 1);
    EXPECT_NEAR(mesh.colors[0].b, 0.2159, 1e-4);
    EXPECT_EQ(mesh.colors[0].a, 1);
    EXPECT_CONTAINS(report(), "face flags: left out");
    EXPECT_CONTAINS(report(), "faces of fewer than 3 corners: left out: 1");
  }
}

TEST_F(PlyFile, OtherElementsAreSkippedAndReported) {
  const Scene scene = read(
      header("ascii",
             "element camera 1\nproperty list int float k\nproperty float f\n" + kTriangle +
                 "element tristrips 1\nproperty list int int vertex_indices\nelement nothing 2000000000\n") +
      "2 0.5 0.5 7\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n4 0 1 2 -1\n");
  EXPECT_EQ(meshOf(scene, 0).triangles.size(), 1u);
  EXPECT_CONTAINS(report(), "camera: left out: 1");
  EXPECT_CONTAINS(report(), "tristrips: left out: 1");
}

TEST_F(PlyFile, AMissingNormalIsThatOfItsTriangles) {
  const Scene scene = read(header("ascii", "element vertex 3\n" + kXyz +
                                               "property float nx\nproperty float ny\nproperty float nz\n"
                                               "element face 1\nproperty list uchar int vertex_indices\n") +
                           "0 0 0 0 0 0\n1 0 0 0 1 0\n0 1 0 0 1 0\n3 0 1 2\n");
  EXPECT_EQ(meshOf(scene, 0).normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}, {0, 1, 0}}));
}

TEST_F(PlyFile, fault4_CountsThatTheFileCannotHoldAreRefusedBeforeMemoryIsTaken) {
  for (const char* count : {"2147483647", "1000000"})
    for (const char* format : {"ascii", "binary_little_endian"})
      EXPECT_CONTAINS(says(header(format, "element vertex " + std::string(count) + "\n" + kXyz) + "0 0 0\n"),
                      "the file is cut off or damaged");
  for (const char* count : {"2147483648", "18446744073709551615", "18446744073709551616", "-1", "x", ""})
    EXPECT_CONTAINS(says(header("ascii", "element vertex " + std::string(count) + "\n" + kXyz)),
                    "line 4: expected how many");
  const std::string lists =
      "element vertex 3\n" + kXyz + "element face 1\nproperty list uint int vertex_indices\n";
  for (const char* length : {"4294967295", "-1", "1.5", "nan", "1e300"})
    EXPECT_CONTAINS(says(header("ascii", lists) + "0 0 0 1 0 0 0 1 0\n" + length + " 0 1 2\n"),
                    "claims a length");
}

TEST_F(PlyFile, fault9_EveryBadIndexAndNumberNamesItsElement) {
  const auto file = [&](const std::string& values) { return header("ascii", kTriangle) + values; };
  const std::string three = "0 0 0 1 0 0 0 1 0\n";
  EXPECT_CONTAINS(says(file(three + "3 0 1 3\n")), "a.ply: face 0: names vertex 3; there are 3");
  EXPECT_CONTAINS(says(file(three + "3 0 1 -1\n")), "face 0: names vertex -1");
  EXPECT_CONTAINS(says(file(three + "3 0 1 nan\n")), "face 0: names vertex");
  EXPECT_CONTAINS(says(file(three + "3 0 1 x\n")), "face 0: expected a number, got 'x'");
  EXPECT_CONTAINS(says(file("0 0 0 1 0 nan 0 1 0\n3 0 1 2\n")), "vertex 1: holds a value");
  EXPECT_CONTAINS(says(file("0 0 0 1 0 0 0 1 1e13\n3 0 1 2\n")), "vertex 2: holds a value");
  const std::string before =
      "element face 1\nproperty list uchar int vertex_indices\nelement vertex 3\n" + kXyz;
  EXPECT_CONTAINS(says(header("ascii", before) + "3 0 1 3\n" + three), "a face names vertex 3; there are 3");
}

TEST_F(PlyFile, fault1_EveryTruncationIsNamed) {
  std::string whole = header("binary_little_endian", kTriangle);
  for (const float f : {0, 0, 0, 1, 0, 0, 0, 1, 0}) whole += bytesOf(float(f), false);
  whole += "\x03" + bytesOf(0, false) + bytesOf(1, false) + bytesOf(2, false);
  EXPECT_EQ(meshOf(read(whole), 0).triangles.size(), 1u);
  for (std::size_t size = 0; size < whole.size(); ++size) says(whole.substr(0, size));
}

TEST_F(PlyFile, WrongHeadersNameTheirLine) {
  EXPECT_CONTAINS(says("PLY\n"), "line 1: expected 'ply'");
  EXPECT_CONTAINS(says("ply\nformat ascii 2.0\n"), "line 2: expected ascii");
  EXPECT_CONTAINS(says("ply\nformat morse 1.0\n"), "line 2: expected ascii");
  EXPECT_CONTAINS(says("ply\nformat ascii 1.0\nproperty float x\n"), "line 3: expected an element");
  EXPECT_CONTAINS(says("ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n"),
                  "line 4: expected a type");
  EXPECT_CONTAINS(says("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\n"),
                  "line 4: expected a whole");
  EXPECT_CONTAINS(says("ply\nformat ascii 1.0\nelement vertex 0\n"), "the header does not end");
  EXPECT_CONTAINS(says("ply\nend_header\n"), "has no format");
  EXPECT_CONTAINS(says(header("ascii", "element vertex 1\nproperty float x\n") + "0\n"), "lack x, y or z");
  EXPECT_CONTAINS(says(header("ascii", "element vertex 1\n" + kXyz) + "0 0 0\n"), "has no faces");
}

}  // namespace
}  // namespace steradian::plugins
