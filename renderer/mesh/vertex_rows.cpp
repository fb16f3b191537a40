// SPDX-License-Identifier: MIT
#include "renderer/mesh/vertex_rows.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/rows.hpp"
#include "shaders/gpu_types.h"

namespace steradian {
namespace {

using namespace gpu;

std::uint32_t flagsOf(const Mesh& mesh) {
  const auto flag = [&](const auto& attribute, std::uint32_t bit) {
    return attribute.empty() || attribute.size() != mesh.positions.size() ? 0u : bit;
  };
  return flag(mesh.normals, MESH_NORMALS) | flag(mesh.tangents, MESH_TANGENTS) | flag(mesh.uv0, MESH_UV0) |
         flag(mesh.uv1, MESH_UV1) | flag(mesh.colors, MESH_COLORS);
}

std::uint32_t unorm15(float x) {
  return std::uint32_t(std::lround(std::clamp(0.5f * x + 0.5f, 0.0f, 1.0f) * 32767.0f));
}

}  // namespace

std::uint32_t packTangent(const glm::vec4& tangent) {
  const float length = std::abs(tangent.x) + std::abs(tangent.y) + std::abs(tangent.z);
  const glm::vec3 t = length > 0.0f ? glm::vec3(tangent) / length : glm::vec3(1.0f, 0.0f, 0.0f);
  const auto folded = [&](float a, float b) {
    return t.z >= 0.0f ? a : std::copysign(1.0f - std::abs(b), a);
  };
  return (tangent.w < 0.0f ? 1u << 31 : 0u) | unorm15(folded(t.x, t.y)) << 15 | unorm15(folded(t.y, t.x));
}

VertexRows vertexRows(const Mesh& mesh) {
  VertexRows made{{}, flagsOf(mesh)};
  if (made.flags == 0) return made;
  const auto has = [&](std::uint32_t flag) { return (made.flags & flag) != 0; };
  const std::uint32_t perVertex =
      has(MESH_NORMALS | MESH_TANGENTS) + has(MESH_UV0 | MESH_UV1) + has(MESH_COLORS);
  const auto first = std::uint32_t(mesh.triangles.size());
  const auto row = [&](std::uint32_t vertex) { return bits(first + vertex * perVertex); };
  made.rows.reserve(mesh.triangles.size() + perVertex * mesh.positions.size());
  for (const glm::uvec3& t : mesh.triangles) made.rows.emplace_back(row(t.x), row(t.y), row(t.z), 0.0f);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (has(MESH_NORMALS | MESH_TANGENTS))
      made.rows.emplace_back(has(MESH_NORMALS) ? mesh.normals[i] : glm::vec3(0.0f),
                             bits(has(MESH_TANGENTS) ? packTangent(mesh.tangents[i]) : 0u));
    if (has(MESH_UV0 | MESH_UV1))
      made.rows.emplace_back(has(MESH_UV0) ? mesh.uv0[i] : glm::vec2(0.0f),
                             has(MESH_UV1) ? mesh.uv1[i] : glm::vec2(0.0f));
    if (has(MESH_COLORS)) made.rows.push_back(mesh.colors[i]);
  }
  return made;
}

}  // namespace steradian
