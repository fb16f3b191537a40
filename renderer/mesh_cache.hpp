// SPDX-License-Identifier: MIT
// Hierarchies and vertex rows of meshes: built once per mesh.
#pragma once
#include <memory>

#include "renderer/identity_cache.hpp"
#include "renderer/mesh/bvh.hpp"
#include "renderer/mesh/vertex_rows.hpp"
#include "renderer/scene/mesh.hpp"

namespace steradian {

/// Hierarchies by identity of their mesh. Any thread.
class MeshCache {
 public:
  /// Builds it the first time, on all threads of the machine.
  std::shared_ptr<const MeshBvh> of(const std::shared_ptr<const Mesh>& mesh);
  std::shared_ptr<const VertexRows> verticesOf(const std::shared_ptr<const Mesh>& mesh);
  /// What the mesh takes on the device; 0 before it is built.
  std::size_t bytesOf(const Mesh& mesh) const;
  /// What belongs to meshes that nobody holds any more.
  void forgetUnused();

 private:
  IdentityCache<Mesh, MeshBvh> hierarchies_;
  IdentityCache<Mesh, VertexRows> vertices_;
};

}  // namespace steradian
