// SPDX-License-Identifier: MIT
// The hierarchy over a whole scene, made anew for every edit: instances of meshes and, where there are many,
// bounded analytic shapes alike. shaders/top_level.glsl walks it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/gpu_meshes.hpp"
#include "renderer/gpu_shapes.hpp"

namespace steradian {

/// Shapes with bounds leave their flat lists for the hierarchy when these cost as much as so many spheres.
/// Measured on Mesa lavapipe 22.3.6, user CPU time of the lists over that of the hierarchy: scattered spheres
/// 16: 0.75, 32: 0.94, 48: 1.2, 64: 1.39, 1,000: 7.9; boxes 8: 0.89, 12: 1.01, 16: 1.28; rects 16: 0.88,
/// 20: 1.01, 24: 1.07; all kinds mixed 12: 1.05, 32: 1.5, 1,000: 11. Projects thesis-room 0.21, cornell
/// 0.50, veach 0.55, glass 0.65, material-grid 1.43.
inline constexpr std::size_t spheresWorthAHierarchy = 42;

struct TopLevelEntry {
  Bounds box;  // camera-relative
  std::uint32_t primitive = 0;
  double steps = 0.0;  // loop turns of a ray through what the box holds
};

struct TopLevel {
  std::vector<glm::vec4> rows;  // TOP_LEVEL_ROWS per node, the root first; none without entries
  double worstSteps = 0.0;      // loop turns of the worst of some rays through everything
};

TopLevel buildTopLevel(const std::vector<TopLevelEntry>& entries);

/// The box of a shape of a kind that has bounds, widened by what float rounds in the shaders.
Bounds boxOf(ShapeKind kind, const Placement& place);
/// What the flat lists of the shapes with bounds cost a ray, in tests of a sphere.
std::size_t listCost(const ShapeLists& shapes);
/// The instances of a scene, and its bounded shapes if they are wanted, by their primitive index.
std::vector<TopLevelEntry> topLevelEntries(const ShapeLists& shapes, const InstanceList& instanceList,
                                           bool withShapes);

}  // namespace steradian
