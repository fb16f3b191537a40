// SPDX-License-Identifier: MIT
#include "renderer/mesh/bvh.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <thread>

#include "renderer/mesh/bvh_split.hpp"
#include "renderer/mesh/grid.hpp"

namespace steradian {
namespace {

using namespace gpu;

// A leaf's triangle costs about what a node's two boxes cost (measured on lavapipe and by fetches).
constexpr SplitCosts costs{1.0f, 1.0f, 4};
constexpr std::size_t worthATask = 4096;

using Rows = std::vector<glm::vec4>;

std::uint32_t leafOf(std::size_t first, std::size_t count) {
  return BVH_LEAF | std::uint32_t(count) << BVH_COUNT_SHIFT | std::uint32_t(first);
}

void append(Rows& nodes, const Rows& subtree) {
  const std::uint32_t offset = std::uint32_t(nodes.size());
  for (glm::vec4 row : subtree) {
    const auto child = std::bit_cast<std::uint32_t>(row.w);
    if ((child & BVH_LEAF) == 0) row.w = std::bit_cast<float>(child + offset);
    nodes.push_back(row);
  }
}

class Builder {
 public:
  explicit Builder(std::span<BoxReference> references) : references_(references) {}

  Rows build(unsigned threads) {
    const auto split = splitReferences(references_, costs, int(BVH_DEPTH), threads);
    if (split) {
      Rows nodes;
      emit(nodes, references_, *split, int(BVH_DEPTH), threads);
      return nodes;
    }
    Bounds all;
    for (const BoxReference& r : references_) all.add(Bounds{r.low, r.high});
    const std::uint32_t leaf = leafOf(0, references_.size());
    return {childRow(all, leaf), childRow(Bounds{}, leaf)};
  }

 private:
  /// The node of a split and all below it, its links counted from the start of `nodes`.
  void emit(Rows& nodes, std::span<BoxReference> part, const Split& split, int levels, unsigned threads) {
    const std::size_t at = nodes.size();
    nodes.resize(at + BVH_NODE_ROWS);
    const auto left = part.first(split.count), right = part.subspan(split.count);
    std::future<std::pair<Rows, std::uint32_t>> later;
    if (threads > 1 && part.size() > worthATask)
      later = std::async(std::launch::async, [&] {
        Rows subtree;
        const std::uint32_t link = child(subtree, right, levels - 1, threads / 2);
        return std::pair(std::move(subtree), link);
      });
    const std::uint32_t leftLink = child(nodes, left, levels - 1, later.valid() ? threads - threads / 2 : 1);
    std::uint32_t rightLink;
    if (later.valid()) {
      const auto [subtree, link] = later.get();
      rightLink = (link & BVH_LEAF) != 0 ? link : link + std::uint32_t(nodes.size());
      append(nodes, subtree);
    } else {
      rightLink = child(nodes, right, levels - 1, 1);
    }
    nodes[at] = childRow(split.left, leftLink);
    nodes[at + 1] = childRow(split.right, rightLink);
  }

  /// The link to a leaf or to a node that is appended.
  std::uint32_t child(Rows& nodes, std::span<BoxReference> part, int levels, unsigned threads) {
    const auto split = splitReferences(part, costs, levels, threads);
    if (!split) return leafOf(std::size_t(part.data() - references_.data()), part.size());
    const std::uint32_t link = std::uint32_t(nodes.size());
    emit(nodes, part, *split, levels, threads);
    return link;
  }

  std::span<BoxReference> references_;
};

Float4 lanes(const glm::vec3& v) {
  return Float4{v.x, v.y, v.z, 0.0f};
}

std::vector<BoxReference> referencesOf(const MeshGrid& grid, std::span<const glm::vec3> positions,
                                       std::span<const glm::uvec3> triangles) {
  std::vector<BoxReference> references;
  references.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const GridTriangle t = grid.triangle(positions, triangles[i]);
    if (!t.hasArea()) continue;
    Bounds bounds;
    for (const glm::vec3& v : t.vertices) bounds.add(lanes(v));
    references.emplace_back(bounds, std::uint32_t(i));
  }
  return references;
}

void writeTriangle(glm::vec4* rows, const GridTriangle& t, std::uint32_t number) {
  rows[0] = glm::vec4(t.vertices[0], std::bit_cast<float>(number));
  rows[1] = glm::vec4(t.vertices[1], 0.0f);
  rows[2] = glm::vec4(t.vertices[2], 0.0f);
}

// What glowing meshes are sampled by. The running share is rounded once per triangle, at both of its ends
// alike.
void writeAreas(MeshBvh& bvh) {
  const auto areaOf = [&](std::size_t i) {
    const glm::dvec3 v0(bvh.triangles[i]), v1(bvh.triangles[i + 1]), v2(bvh.triangles[i + 2]);
    return 0.5 * glm::length(glm::cross(v1 - v0, v2 - v0));
  };
  double total = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < bvh.triangles.size(); i += BVH_TRIANGLE_ROWS) total += areaOf(i);
  for (std::size_t i = 0; i < bvh.triangles.size(); i += BVH_TRIANGLE_ROWS) {
    bvh.triangles[i + 1].w = float(sum / total);
    sum += areaOf(i);
    bvh.triangles[i + 2].w = float(sum / total);
  }
  bvh.area = total * bvh.cell * bvh.cell;
}

int depthBelow(const Rows& nodes, std::uint32_t node) {
  int deepest = 0;
  for (std::uint32_t i = 0; i < BVH_NODE_ROWS; ++i) {
    const auto link = std::bit_cast<std::uint32_t>(nodes[node + i].w);
    if ((link & BVH_LEAF) == 0) deepest = std::max(deepest, depthBelow(nodes, link));
  }
  return deepest + 1;
}

}  // namespace

MeshBvh buildBvh(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                 unsigned threads) {
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  const MeshGrid grid(positions, triangles);
  MeshBvh bvh;
  bvh.centre = grid.centre;
  bvh.cell = grid.cell;
  std::vector<BoxReference> references = referencesOf(grid, positions, triangles);
  if (references.empty()) return bvh;
  bvh.nodes = Builder(references).build(threads);
  bvh.depth = depthBelow(bvh.nodes, 0);
  bvh.triangles.resize(references.size() * BVH_TRIANGLE_ROWS);
  for (std::size_t i = 0; i < references.size(); ++i) {
    const std::uint32_t number = references[i].number();
    writeTriangle(&bvh.triangles[i * BVH_TRIANGLE_ROWS], grid.triangle(positions, triangles[number]), number);
  }
  writeAreas(bvh);
  bvh.steps = probeSteps(bvh, 512);
  return bvh;
}

void refit(MeshBvh& bvh, std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
  if (bvh.empty()) return;
  const MeshGrid grid(positions, triangles);
  bvh.centre = grid.centre;
  bvh.cell = grid.cell;
  for (std::size_t i = 0; i < bvh.triangles.size(); i += BVH_TRIANGLE_ROWS) {
    const auto number = std::bit_cast<std::uint32_t>(bvh.triangles[i].w);
    writeTriangle(&bvh.triangles[i], grid.triangle(positions, triangles[number]), number);
  }
  // Children follow their parents, so backwards every child is known before it is asked for.
  std::vector<Bounds> bounds(bvh.nodes.size() / BVH_NODE_ROWS);
  for (std::size_t row = bvh.nodes.size(); row-- > 0;) {
    const auto link = std::bit_cast<std::uint32_t>(bvh.nodes[row].w);
    Bounds child;
    if (isNothing(bvh.nodes[row])) continue;
    if ((link & BVH_LEAF) == 0) child = bounds[link / BVH_NODE_ROWS];
    const std::size_t first = std::size_t(link & BVH_FIRST_MASK) * BVH_TRIANGLE_ROWS;
    const std::size_t count = (link & BVH_LEAF) == 0 ? 0 : (link & ~BVH_LEAF) >> BVH_COUNT_SHIFT;
    for (std::size_t i = first; i < first + count * BVH_TRIANGLE_ROWS; ++i)
      child.add(lanes(glm::vec3(bvh.triangles[i])));
    bvh.nodes[row] = childRow(child, link);
    bounds[row / BVH_NODE_ROWS].add(child);
  }
  writeAreas(bvh);
  bvh.steps = probeSteps(bvh, 512);
}

}  // namespace steradian
