// SPDX-License-Identifier: MIT
// Triangle lists, strips and fans, with and without indices, as one list.
#include "mesh.hpp"
#include "views.hpp"

namespace gltf {

namespace {

std::vector<std::uint32_t> readIndices(const Document& document, int accessor, std::size_t vertices) {
  const std::vector<std::uint32_t> out = readIntegers(document, accessor, {"indices", 1, 1});
  for (std::size_t i = 0; i < out.size(); ++i)
    if (out[i] >= vertices)
      throw sdk::BadInput(at("accessors", std::size_t(accessor)) + ": expected indices below the " +
                          std::to_string(vertices) + " vertices, got " + std::to_string(out[i]) +
                          " in element " + std::to_string(i));
  return out;
}

}  // namespace

std::vector<std::uint32_t> readTriangles(const Document& document, const tinygltf::Primitive& primitive,
                                         std::size_t vertices, std::vector<std::string>& notes) {
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES)
    throw sdk::BadInput(primitive.mode == TINYGLTF_MODE_POINTS ? "points have no surface"
                                                               : "lines have no surface");
  if (vertices > UINT32_MAX) throw sdk::BadInput("has more than 2^32 vertices");
  std::vector<std::uint32_t> corners;
  if (primitive.indices >= 0)
    corners = readIndices(document, primitive.indices, vertices);
  else
    for (std::size_t i = 0; i < vertices; ++i) corners.push_back(std::uint32_t(i));

  if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
    if (corners.size() % 3 != 0) notes.push_back("the last corners make no triangle");
    corners.resize(corners.size() / 3 * 3);
    return corners;
  }
  // glTF 2.0, 3.7.2.1: every other triangle of a strip is turned, so that all face the same way.
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    const bool fan = primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
    const std::size_t first = fan ? i + 1 : i;
    const std::size_t second = fan ? i + 2 : i + 1 + i % 2;
    const std::size_t third = fan ? 0 : i + 2 - i % 2;
    out.insert(out.end(), {corners[first], corners[second], corners[third]});
  }
  return out;
}

}  // namespace gltf
