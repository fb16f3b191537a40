// SPDX-License-Identifier: MIT
// Bounding volume hierarchy of one triangle mesh, in the form that shaders/bvh.glsl walks.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "shaders/gpu_types.h"

namespace steradian {

/// A mesh in its own grid: coordinates relative to the middle of its box, in units of `cell`, so that the box
/// spans about 65,400 cells and every bound of the hierarchy is a 16-bit integer.
struct MeshBvh {
  /// BVH_NODE_ROWS per node, the root first, children after their parents. Each row is one child: bounds
  /// along x, y and z (bits: low | high << 16, counted from -BVH_ORIGIN) | bits: node, or BVH_LEAF with count
  /// and first triangle. Every bound holds its triangles.
  std::vector<glm::vec4> nodes;
  /// BVH_TRIANGLE_ROWS per triangle in the order of the leaves: vertex 0, bits: index in the mesh | 1, share
  /// of the mesh's area before this triangle | 2, share up to its end
  std::vector<glm::vec4> triangles;
  glm::dvec3 centre{0.0};  // mesh position = centre + cell * grid position
  double cell = 1.0;       // metres of the mesh
  int depth = 0;           // nodes on the longest way down
  double area = 0.0;       // square metres of the mesh
  double steps = 0.0;      // loop turns of the worst of some rays shot through it

  bool empty() const { return triangles.empty(); }
  std::size_t triangleCount() const { return triangles.size() / gpu::BVH_TRIANGLE_ROWS; }
};

/// Binned surface area heuristic (Wald 2007). Triangles without area and those with a vertex that is not
/// finite are left out. Takes about 150 bytes per triangle while it runs. `threads` 0 = all of the machine;
/// the result does not depend on it. Any thread.
MeshBvh buildBvh(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                 unsigned threads = 0);

/// The same hierarchy around moved vertices, for meshes that deform: much faster than building, slower to
/// trace the more they moved. `positions` as at building; a triangle that has lost its area stays in.
void refit(MeshBvh& bvh, std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

/// Loop turns that the traversal of the worst of `rays` random rays takes.
double probeSteps(const MeshBvh& bvh, int rays);

/// Nodes and triangles that a ray (mesh coordinates, unit direction) tests at least to know its hit at
/// `length`.
double visitsBefore(const MeshBvh& bvh, const glm::dvec3& origin, const glm::dvec3& direction, double length);

}  // namespace steradian
