// SPDX-License-Identifier: MIT
#include "renderer/gpu_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/mesh/bvh_split.hpp"
#include "renderer/mesh/grid.hpp"
#include "renderer/rows.hpp"

namespace steradian {
namespace {

using namespace gpu;

const Mesh* meshOf(const Object& object) {
  const auto* g = std::get_if<Geometry>(&object.content);
  const auto* shape = g ? std::get_if<MeshShape>(&g->shape) : nullptr;
  return shape ? shape->mesh.get() : nullptr;
}

// The box of a mesh in its grid.
Bounds gridBox(const MeshBvh& bvh) {
  Bounds box;
  for (std::uint32_t i = 0; i < BVH_NODE_ROWS; ++i)
    if (!isNothing(bvh.nodes[i])) box.add(boundsOf(bvh.nodes[i]));
  return box;
}

// The box of the transformed box, widened by what float rounds in the shaders.
Bounds worldBox(const Bounds& grid, const glm::dmat3& worldFromMesh, const glm::dvec3& centre) {
  Bounds box;
  for (int axis = 0; axis < 3; ++axis) {
    double middle = centre[axis], half = 0.0;
    for (int i = 0; i < 3; ++i) {
      middle += worldFromMesh[i][axis] * 0.5 * (double(grid.low[i]) + grid.high[i]);
      half += std::abs(worldFromMesh[i][axis]) * 0.5 * (double(grid.high[i]) - grid.low[i]);
    }
    half += 1e-6 * (std::abs(middle) + half);
    box.low[axis] = std::nextafter(float(middle - half), -Bounds::infinite);
    box.high[axis] = std::nextafter(float(middle + half), Bounds::infinite);
  }
  return box;
}

std::uint32_t leafOf(std::uint32_t instance) {
  return BVH_LEAF | 1u << BVH_COUNT_SHIFT | instance;
}

void putChild(glm::vec4* rows, const Bounds& box, std::uint32_t link) {
  rows[0] = {box.low[0], box.low[1], box.low[2], bits(link)};
  rows[1] = {box.high[0], box.high[1], box.high[2], 0.0f};
}

// The node of a split and all below it.
std::uint32_t appendTopLevel(std::vector<glm::vec4>& rows, std::span<BoxReference> part, int levels) {
  // A leaf is one instance: its box is tested before its mesh is entered.
  constexpr SplitCosts costs{1.0f, 20.0f, 1};
  const auto split = splitReferences(part, costs, levels, 1);
  if (!split) return leafOf(part[0].number());
  const std::size_t at = rows.size();
  rows.resize(at + TOP_LEVEL_ROWS);
  const std::uint32_t left = appendTopLevel(rows, part.first(split->count), levels - 1);
  const std::uint32_t right = appendTopLevel(rows, part.subspan(split->count), levels - 1);
  putChild(&rows[at], split->left, left);
  putChild(&rows[at + 2], split->right, right);
  return std::uint32_t(at);
}

bool meets(const Bounds& box, const glm::dvec3& o, const glm::dvec3& d) {
  double enter = -INFINITY, leave = INFINITY;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / (d[axis] != 0.0 ? d[axis] : 1e-300);
    const double a = (box.low[axis] - o[axis]) * inverse, b = (box.high[axis] - o[axis]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

}  // namespace

std::shared_ptr<const MeshBvh> MeshCache::of(const std::shared_ptr<const Mesh>& mesh) {
  Entry& entry = entries_[mesh.get()];
  if (!entry.bvh || entry.mesh.expired()) {
    entry.mesh = mesh;
    entry.bvh = std::make_shared<const MeshBvh>(buildBvh(mesh->positions, mesh->triangles));
    entry.vertices = std::make_shared<const VertexRows>(vertexRows(*mesh));
  }
  return entry.bvh;
}

std::shared_ptr<const VertexRows> MeshCache::verticesOf(const std::shared_ptr<const Mesh>& mesh) {
  of(mesh);
  return entries_.at(mesh.get()).vertices;
}

void MeshCache::forgetUnused() {
  std::erase_if(entries_, [](const auto& entry) { return entry.second.mesh.expired(); });
}

MeshPlaces::MeshPlaces(const Scene& scene, MeshCache& cache) {
  cache.forgetUnused();
  std::uint32_t next = 0;
  for (const Object& object : scene.objects) {
    const Mesh* mesh = meshOf(object);
    if (!mesh || !index_.emplace(mesh, places_.size()).second) continue;
    const auto& shared = std::get<MeshShape>(std::get<Geometry>(object.content).shape).mesh;
    MeshPlace place{cache.of(shared), cache.verticesOf(shared)};
    place.nodeRow = next;
    place.triangleRow = next + std::uint32_t(place.bvh->nodes.size());
    place.vertexRow = place.triangleRow + std::uint32_t(place.bvh->triangles.size());
    next = place.vertexRow + std::uint32_t(place.vertices->rows.size());
    places_.push_back(std::move(place));
  }
}

void InstanceList::add(const MeshPlace& mesh, const glm::dmat4& worldFromObject, const glm::dvec3& origin,
                       SurfaceLink link) {
  const MeshBvh& bvh = *mesh.bvh;
  const glm::dmat3 worldFromMesh = glm::dmat3(worldFromObject) * bvh.cell;
  const double determinant = glm::determinant(worldFromMesh);
  if (bvh.empty() || !std::isfinite(determinant) || determinant == 0.0) return;
  const glm::dvec3 centre = glm::dvec3(worldFromObject * glm::dvec4(bvh.centre, 1.0)) - origin;
  const glm::dmat3 inward = glm::transpose(glm::inverse(worldFromMesh)),
                   outward = glm::transpose(worldFromMesh);
  shapes.rows.insert(shapes.rows.end(),
                     {row(inward[0], centre.x), row(inward[1], centre.y), row(inward[2], centre.z),
                      glm::vec4(bits(mesh.nodeRow), bits(mesh.triangleRow), bits(mesh.vertexRow),
                                bits(mesh.vertices->flags)),
                      row(outward[0], 0.0), row(outward[1], 0.0), row(outward[2], 0.0)});
  link.vertexFlags = mesh.vertices->flags;
  shapes.links.push_back(link);
  shapes.places.push_back({worldFromMesh, centre});
  boxes.push_back(worldBox(gridBox(bvh), worldFromMesh, centre));
  steps.push_back(bvh.steps);
}

std::vector<glm::vec4> InstanceList::topLevelRows() const {
  std::vector<BoxReference> references;
  for (std::size_t i = 0; i < boxes.size(); ++i) references.emplace_back(boxes[i], std::uint32_t(i));
  std::vector<glm::vec4> rows;
  if (references.size() > 1) {
    appendTopLevel(rows, references, int(TOP_LEVEL_DEPTH));
  } else if (references.size() == 1) {
    rows.resize(TOP_LEVEL_ROWS);
    Bounds nowhere;
    nowhere.low = nowhere.high = Float4{1e30f, 1e30f, 1e30f, 0.0f};
    putChild(&rows[0], boxes[0], leafOf(0));
    putChild(&rows[2], nowhere, leafOf(0));
  }
  return rows;
}

double InstanceList::worstSteps() const {
  if (boxes.empty()) return 0.0;
  Bounds all;
  for (const Bounds& box : boxes) all.add(box);
  std::mt19937 random(1);
  const auto pointInside = [&] {
    glm::dvec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = all.low[axis] + (double(all.high[axis]) - all.low[axis]) * (double(random()) * 0x1p-32);
    return p;
  };
  double worst = 0.0;
  const int rays = boxes.size() > 1000 ? 16 : 64;
  for (int ray = 0; ray < rays; ++ray) {
    const glm::dvec3 o = pointInside(), d = pointInside() - o;
    double sum = 2.0 * std::log2(double(boxes.size()) + 1.0) + 4.0;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (meets(boxes[i], o, d)) sum += steps[i] + 4.0;
    worst = std::max(worst, sum);
  }
  return worst;
}

}  // namespace steradian
