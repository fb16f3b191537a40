// SPDX-License-Identifier: MIT
// The grid that a mesh's hierarchy counts in: what is rounded, and which way.
#pragma once
#include <array>
#include <span>

#include "renderer/mesh/bounds.hpp"

namespace steradian {

struct GridTriangle {
  std::array<glm::vec3, 3> vertices;
  /// False for slivers of no area at all and for vertices that are not finite.
  bool hasArea() const;
};

/// Coordinates relative to the middle of the box, in cells. Each is rounded once, so triangles that share a
/// vertex still share it.
struct MeshGrid {
  glm::dvec3 centre{0.0};
  double cell = 1.0;

  /// Around the vertices that the triangles use, as far as they are finite.
  MeshGrid(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);
  GridTriangle triangle(std::span<const glm::vec3> positions, const glm::uvec3& corners) const;
};

/// A row of a node: the bounds of one child, rounded outward, and its link. Empty bounds become a point in a
/// corner.
glm::vec4 childRow(const Bounds& bounds, std::uint32_t link);
bool isNothing(const glm::vec4& childRow);
/// The bounds of a row as rays meet them, in cells.
Bounds boundsOf(const glm::vec4& childRow);

}  // namespace steradian
