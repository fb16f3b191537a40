// SPDX-License-Identifier: MIT
// How much work a ray through a mesh can be, found out by asking: the loop budget of some drivers depends on
// it.
#include <algorithm>
#include <random>

#include "renderer/mesh/bvh.hpp"
#include "renderer/mesh/grid.hpp"

namespace steradian {
namespace {

using namespace gpu;

struct Line {
  glm::dvec3 origin, inverse;  // 1 / direction
};

bool meets(const Line& line, const Bounds& box) {
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (double(box.low[axis]) - line.origin[axis]) * line.inverse[axis];
    const double b = (double(box.high[axis]) - line.origin[axis]) * line.inverse[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

// Every node and triangle that the whole line meets, as for a ray that hits nothing before it leaves the
// mesh; a leaf costs two failing loop tests more.
double turns(const MeshBvh& bvh, const Line& line) {
  double sum = 0.0;
  std::vector<std::uint32_t> open{0u};
  while (!open.empty()) {
    const std::uint32_t node = open.back();
    open.pop_back();
    sum += 1.0;
    for (std::uint32_t i = 0; i < BVH_NODE_ROWS; ++i) {
      const glm::vec4& row = bvh.nodes[node + i];
      if (isNothing(row) || !meets(line, boundsOf(row))) continue;
      const auto link = std::bit_cast<std::uint32_t>(row.w);
      if ((link & BVH_LEAF) == 0)
        open.push_back(link);
      else
        sum += double((link & ~BVH_LEAF) >> BVH_COUNT_SHIFT) + 3.0;
    }
  }
  return sum;
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
    glm::dvec3 inverse;
    for (int axis = 0; axis < 3; ++axis)
      inverse[axis] = direction[axis] != 0.0 ? 1.0 / direction[axis] : 1e300;
    worst = std::max(worst, turns(bvh, {from, inverse}));
  }
  return worst;
}

}  // namespace steradian
