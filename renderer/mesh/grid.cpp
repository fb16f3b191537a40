// SPDX-License-Identifier: MIT
#include "renderer/mesh/grid.hpp"

#include <algorithm>
#include <cmath>

#include "shaders/gpu_types.h"

namespace steradian {
namespace {

// The box reaches so many cells from its middle, which leaves every rounded bound within 16 bits.
constexpr double reach = 32702.0;
constexpr std::uint32_t mostBound = 65406;
constexpr std::uint32_t nowhere = 65407u << 16 | 65407u;  // a point beside the box

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The row's floats must not look like a NaN, whose bits nobody promises to keep: the upper half never has all
// of the exponent's bits.
std::uint32_t withoutNan(std::uint32_t high) {
  return (high & 0x7f80u) == 0x7f80u ? (high | 0x7fu) + 1u : high;
}

float wordOf(float low, float high) {
  if (!(low <= high)) return std::bit_cast<float>(nowhere);
  const double a = std::floor(double(low) + gpu::BVH_ORIGIN), b = std::ceil(double(high) + gpu::BVH_ORIGIN);
  const auto from = std::uint32_t(std::clamp(a, 0.0, double(mostBound)));
  const auto to = std::uint32_t(std::clamp(b, 0.0, double(mostBound)));
  return std::bit_cast<float>(from | withoutNan(to) << 16);
}

}  // namespace

bool GridTriangle::hasArea() const {
  for (const glm::vec3& v : vertices)
    if (!finite(v)) return false;
  const glm::dvec3 a(vertices[0]), b(vertices[1]), c(vertices[2]);
  return glm::cross(b - a, c - a) != glm::dvec3(0.0);
}

MeshGrid::MeshGrid(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
  glm::vec3 low(Bounds::infinite), high(-Bounds::infinite);
  for (const glm::uvec3& t : triangles)
    for (int corner = 0; corner < 3; ++corner) {
      const glm::vec3& p = positions[t[corner]];
      if (!finite(p)) continue;
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  if (!(low.x <= high.x)) return;
  centre = 0.5 * (glm::dvec3(low) + glm::dvec3(high));
  const glm::dvec3 half = 0.5 * (glm::dvec3(high) - glm::dvec3(low));
  const double most = std::max({half.x, half.y, half.z});
  if (most > 0.0) cell = most / reach;
}

GridTriangle MeshGrid::triangle(std::span<const glm::vec3> positions, const glm::uvec3& corners) const {
  GridTriangle t;
  for (int i = 0; i < 3; ++i) t.vertices[i] = glm::vec3((glm::dvec3(positions[corners[i]]) - centre) / cell);
  return t;
}

glm::vec4 childRow(const Bounds& bounds, std::uint32_t link) {
  return {wordOf(bounds.low[0], bounds.high[0]), wordOf(bounds.low[1], bounds.high[1]),
          wordOf(bounds.low[2], bounds.high[2]), std::bit_cast<float>(link)};
}

bool isNothing(const glm::vec4& childRow) {
  return std::bit_cast<std::uint32_t>(childRow.x) == nowhere;
}

Bounds boundsOf(const glm::vec4& childRow) {
  Bounds bounds;
  for (int axis = 0; axis < 3; ++axis) {
    const auto word = std::bit_cast<std::uint32_t>(childRow[axis]);
    bounds.low[axis] = float(word & 0xffffu) - gpu::BVH_ORIGIN;
    bounds.high[axis] = float(word >> 16) - gpu::BVH_ORIGIN;
  }
  return bounds;
}

}  // namespace steradian
