// SPDX-License-Identifier: MIT
#include "renderer/mesh_cache.hpp"

namespace steradian {

std::shared_ptr<const MeshBvh> MeshCache::of(const std::shared_ptr<const Mesh>& mesh) {
  return hierarchies_.of(mesh, [&] { return buildBvh(mesh->positions, mesh->triangles); });
}

std::shared_ptr<const VertexRows> MeshCache::verticesOf(const std::shared_ptr<const Mesh>& mesh) {
  return vertices_.of(mesh, [&] { return vertexRows(*mesh); });
}

std::size_t MeshCache::bytesOf(const Mesh& mesh) const {
  const auto bvh = hierarchies_.find(&mesh);
  const auto vertices = vertices_.find(&mesh);
  const std::size_t rows =
      (bvh ? bvh->nodes.size() + bvh->triangles.size() : 0) + (vertices ? vertices->rows.size() : 0);
  return rows * sizeof(glm::vec4);
}

void MeshCache::forgetUnused() {
  hierarchies_.forgetUnused();
  vertices_.forgetUnused();
}

}  // namespace steradian
