// SPDX-License-Identifier: MIT
#include "renderer/top_level.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "renderer/mesh/bvh_split.hpp"
#include "renderer/rows.hpp"

namespace steradian {
namespace {

using namespace gpu;

constexpr ShapeKind boundedKinds[] = {spheres, boxes, rects, disks, cylinders, ellipsoids};

std::uint32_t linkTo(std::uint32_t primitive) {
  return BVH_LEAF | 1u << BVH_COUNT_SHIFT | primitive;
}

void putBox(glm::vec4* rows, const Bounds& box, std::uint32_t link) {
  rows[0] = {box.low[0], box.low[1], box.low[2], bits(link)};
  rows[1] = {box.high[0], box.high[1], box.high[2], 0.0f};
}

// The link to a node of a split and all below it, or to a leaf.
std::uint32_t append(std::vector<glm::vec4>& rows, std::span<BoxReference> part, int levels) {
  // A leaf is one primitive: its box is tested before its mesh is entered. Leaves of up to four shapes took
  // 1.2 times as long on the CPU driver.
  constexpr SplitCosts costs{1.0f, 20.0f, 1};
  const auto split = splitReferences(part, costs, levels, 1);
  if (!split) return linkTo(part[0].number());
  const std::size_t at = rows.size();
  rows.resize(at + TOP_LEVEL_ROWS);
  const std::uint32_t left = append(rows, part.first(split->count), levels - 1);
  const std::uint32_t right = append(rows, part.subspan(split->count), levels - 1);
  putBox(&rows[at], split->left, left);
  putBox(&rows[at + 2], split->right, right);
  return std::uint32_t(at);
}

std::vector<glm::vec4> rowsOver(const std::vector<TopLevelEntry>& entries) {
  std::vector<BoxReference> references;
  references.reserve(entries.size());
  for (const TopLevelEntry& entry : entries) references.emplace_back(entry.box, entry.primitive);
  std::vector<glm::vec4> rows;
  rows.reserve(entries.size() * TOP_LEVEL_ROWS);
  if (append(rows, references, int(TOP_LEVEL_DEPTH)) == 0) return rows;
  // The root is a node even of a single leaf, whose twin nobody meets.
  Bounds nowhere;
  nowhere.low = nowhere.high = Float4{1e30f, 1e30f, 1e30f, 0.0f};
  rows.resize(TOP_LEVEL_ROWS);
  putBox(&rows[0], entries[0].box, linkTo(entries[0].primitive));
  putBox(&rows[2], nowhere, linkTo(entries[0].primitive));
  return rows;
}

bool meetsBox(const glm::vec4* rows, const glm::dvec3& o, const glm::dvec3& inverse) {
  double enter = -INFINITY, leave = INFINITY;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (rows[0][axis] - o[axis]) * inverse[axis], b = (rows[1][axis] - o[axis]) * inverse[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

// Every node and leaf that the whole line meets, as for a ray that hits nothing; a leaf costs the failing
// tests of the loops around it too.
double turnsAlong(const std::vector<glm::vec4>& rows, const std::vector<double>& stepsOf, const glm::dvec3& o,
                  const glm::dvec3& inverse) {
  double turns = 4.0;
  std::vector<std::uint32_t> open{0u};
  while (!open.empty()) {
    const std::uint32_t node = open.back();
    open.pop_back();
    turns += 1.0;
    for (std::uint32_t child = node; child < node + TOP_LEVEL_ROWS; child += 2) {
      if (!meetsBox(&rows[child], o, inverse)) continue;
      const auto link = std::bit_cast<std::uint32_t>(rows[child].w);
      if ((link & BVH_LEAF) == 0)
        open.push_back(link);
      else
        turns += 4.0 + stepsOf[link & BVH_FIRST_MASK];
    }
  }
  return turns;
}

double worstTurns(const std::vector<glm::vec4>& rows, const std::vector<TopLevelEntry>& entries) {
  Bounds all;
  std::vector<double> stepsOf;
  for (const TopLevelEntry& entry : entries) {
    all.add(entry.box);
    stepsOf.resize(std::max<std::size_t>(stepsOf.size(), entry.primitive + std::size_t(1)));
    stepsOf[entry.primitive] = entry.steps;
  }
  std::mt19937 random(1);
  const auto pointInside = [&] {
    glm::dvec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = all.low[axis] + (double(all.high[axis]) - all.low[axis]) * (double(random()) * 0x1p-32);
    return p;
  };
  double worst = 0.0;
  for (int ray = 0; ray < 64; ++ray) {
    const glm::dvec3 o = pointInside(), d = pointInside() - o;
    glm::dvec3 inverse;
    for (int axis = 0; axis < 3; ++axis) inverse[axis] = d[axis] != 0.0 ? 1.0 / d[axis] : 1e300;
    worst = std::max(worst, turnsAlong(rows, stepsOf, o, inverse));
  }
  return worst;
}

// Half the size of the box of a unit shape under a linear map, along one axis.
double halfAlong(ShapeKind kind, const glm::dmat3& m, int axis) {
  const double x = std::abs(m[0][axis]), y = std::abs(m[1][axis]), z = std::abs(m[2][axis]);
  switch (kind) {
    case boxes:
      return x + y + z;
    case rects:
      return x + z;
    case disks:
      return std::hypot(x, z);
    case cylinders:
      return std::hypot(x, z) + y;
    default:  // spheres and ellipsoids
      return std::hypot(x, y, z);
  }
}

// How much the unit frame of a sheared shape magnifies what is rounded in it: 1 for right angles.
double shearOf(const glm::dmat3& m) {
  const glm::dmat3 inverse = glm::transpose(glm::inverse(m));
  double most = 1.0;
  for (int i = 0; i < 3; ++i) most = std::max(most, glm::length(m[i]) * glm::length(inverse[i]));
  return most;
}

}  // namespace

TopLevel buildTopLevel(const std::vector<TopLevelEntry>& entries) {
  TopLevel made;
  if (entries.empty()) return made;
  made.rows = rowsOver(entries);
  made.worstSteps = worstTurns(made.rows, entries);
  return made;
}

Bounds boxOf(ShapeKind kind, const Placement& place) {
  // Rays beyond this know no place any more.
  constexpr double farthest = 1e15;
  const glm::dmat3& m = place.worldFromUnit;
  glm::dvec3 half;
  for (int axis = 0; axis < 3; ++axis) half[axis] = halfAlong(kind, m, axis);
  // The tests round relative to the distance of the shape from the camera and, by the ray's own margin, of
  // the ray from the camera: some units in the last place, of any axis.
  const glm::dvec3 reach = glm::abs(place.centre) + half;
  const double rounding = 1e-6 * std::max({reach.x, reach.y, reach.z}) * (kind == spheres ? 1.0 : shearOf(m));
  Bounds box;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = place.centre[axis] - half[axis] - rounding,
                 high = place.centre[axis] + half[axis] + rounding;
    box.low[axis] = std::nextafter(float(std::clamp(low, -farthest, farthest)), -Bounds::infinite);
    box.high[axis] = std::nextafter(float(std::clamp(high, -farthest, farthest)), Bounds::infinite);
  }
  return box;
}

std::size_t listCost(const ShapeLists& shapes) {
  std::size_t cost = 0;
  for (const ShapeKind kind : boundedKinds) {
    const bool flat = kind == rects || kind == disks;
    cost += shapes.kinds[kind].links.size() * (kind == spheres ? 1 : (flat ? 2 : 3));
  }
  return cost;
}

std::vector<TopLevelEntry> topLevelEntries(const ShapeLists& shapes, const InstanceList& instanceList,
                                           bool withShapes) {
  std::vector<TopLevelEntry> entries;
  std::uint32_t first = 0;
  for (int kind = 0; kind < instances; ++kind) {
    const std::vector<Placement>& places = shapes.kinds[kind].places;
    const bool bounded = std::ranges::find(boundedKinds, ShapeKind(kind)) != std::end(boundedKinds);
    for (std::size_t i = 0; withShapes && bounded && i < places.size(); ++i)
      entries.push_back({boxOf(ShapeKind(kind), places[i]), first + std::uint32_t(i), 0.0});
    first += std::uint32_t(places.size());
  }
  for (std::size_t i = 0; i < instanceList.boxes.size(); ++i)
    entries.push_back({instanceList.boxes[i], first + std::uint32_t(i), instanceList.steps[i]});
  return entries;
}

}  // namespace steradian
