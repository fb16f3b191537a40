// SPDX-License-Identifier: MIT
#include "renderer/gpu_meshes.hpp"

#include <cmath>

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

}  // namespace

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
  const double scale2 = std::pow(std::abs(glm::determinant(glm::dmat3(worldFromObject))), 2.0 / 3.0);
  lights.push_back({mesh.triangleRow, std::uint32_t(bvh.triangleCount()), bvh.area * scale2});
  steps.push_back(bvh.steps);
}

}  // namespace steradian
