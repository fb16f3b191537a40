// SPDX-License-Identifier: MIT
// How much work a ray through a mesh is, found out by asking: the loop budget of some drivers depends on it,
// and it tells the growth with size apart from what caches do.
#include <algorithm>
#include <random>

#include "renderer/mesh/bvh.hpp"
#include "renderer/mesh/grid.hpp"

namespace steradian {
namespace {

using namespace gpu;

struct Segment {
  glm::dvec3 origin, inverse;  // 1 / direction
  double begin, end;           // in units of the direction
};

Segment segmentOf(const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end) {
  Segment segment{origin, {}, begin, end};
  for (int axis = 0; axis < 3; ++axis)
    segment.inverse[axis] = direction[axis] != 0.0 ? 1.0 / direction[axis] : 1e300;
  return segment;
}

bool meets(const Segment& line, const Bounds& box) {
  double enter = line.begin, leave = line.end;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (double(box.low[axis]) - line.origin[axis]) * line.inverse[axis];
    const double b = (double(box.high[axis]) - line.origin[axis]) * line.inverse[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

struct Visits {
  double nodes = 0.0, leaves = 0.0, triangles = 0.0;
};

/// All that the segment meets.
Visits visitsAlong(const MeshBvh& bvh, const Segment& line) {
  Visits visits;
  std::vector<std::uint32_t> open{0u};
  while (!open.empty()) {
    const std::uint32_t node = open.back();
    open.pop_back();
    visits.nodes += 1.0;
    for (std::uint32_t i = 0; i < BVH_NODE_ROWS; ++i) {
      const glm::vec4& row = bvh.nodes[node + i];
      if (isNothing(row) || !meets(line, boundsOf(row))) continue;
      const auto link = std::bit_cast<std::uint32_t>(row.w);
      if ((link & BVH_LEAF) == 0) {
        open.push_back(link);
      } else {
        visits.leaves += 1.0;
        visits.triangles += double((link & ~BVH_LEAF) >> BVH_COUNT_SHIFT);
      }
    }
  }
  return visits;
}

}  // namespace

double probeSteps(const MeshBvh& bvh, int rays) {
  if (bvh.empty()) return 0.0;
  Bounds box;
  for (std::uint32_t i = 0; i < BVH_NODE_ROWS; ++i)
    if (!isNothing(bvh.nodes[i])) box.add(boundsOf(bvh.nodes[i]));
  std::mt19937 random(1);
  const auto pointInBox = [&] {
    glm::dvec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = box.low[axis] + (box.high[axis] - box.low[axis]) * (double(random()) * 0x1p-32);
    return p;
  };
  double worst = 0.0;
  for (int ray = 0; ray < rays; ++ray) {
    const glm::dvec3 from = pointInBox(), direction = pointInBox() - from;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const Visits met = visitsAlong(bvh, segmentOf(from, direction, -infinite, infinite));
    // As for a ray that hits nothing before it leaves the mesh; a leaf costs failing loop tests more.
    worst = std::max(worst, met.nodes + met.triangles + 3.0 * met.leaves);
  }
  return worst;
}

double visitsBefore(const MeshBvh& bvh, const glm::dvec3& origin, const glm::dvec3& direction,
                    double length) {
  if (bvh.empty()) return 0.0;
  const glm::dvec3 inGrid = (origin - bvh.centre) / bvh.cell;
  const Visits met = visitsAlong(bvh, segmentOf(inGrid, direction, 0.0, length / bvh.cell));
  return met.nodes + met.triangles;
}

}  // namespace steradian
