// SPDX-License-Identifier: MIT
// Meshes -> the rows that shaders read: built once per mesh, placed by instances, found through a small
// hierarchy that is made anew for every edit.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include "renderer/gpu_shapes.hpp"
#include "renderer/mesh/bounds.hpp"
#include "renderer/mesh/bvh.hpp"

namespace steradian {

/// Hierarchies by identity of their mesh. One thread at a time.
class MeshCache {
 public:
  /// Builds it the first time, on all threads of the machine.
  std::shared_ptr<const MeshBvh> of(const std::shared_ptr<const Mesh>& mesh);
  std::shared_ptr<const VertexRows> verticesOf(const std::shared_ptr<const Mesh>& mesh);
  /// What belongs to meshes that nobody holds any more.
  void forgetUnused();

 private:
  struct Entry {
    std::weak_ptr<const Mesh> mesh;
    std::shared_ptr<const MeshBvh> bvh;
    std::shared_ptr<const VertexRows> vertices;
  };
  std::map<const Mesh*, Entry> entries_;
};

/// Where the parts of a mesh lie in the mesh buffer.
struct MeshPlace {
  std::shared_ptr<const MeshBvh> bvh;
  std::shared_ptr<const VertexRows> vertices;
  std::uint32_t nodeRow = 0, triangleRow = 0, vertexRow = 0;
};

/// All meshes of a scene, also hidden ones, so that showing and moving objects uploads nothing.
class MeshPlaces {
 public:
  MeshPlaces(const Scene& scene, MeshCache& cache);
  /// In the order of the buffer.
  const std::vector<MeshPlace>& all() const { return places_; }
  const MeshPlace& of(const Mesh& mesh) const { return places_[index_.at(&mesh)]; }

 private:
  std::vector<MeshPlace> places_;
  std::map<const Mesh*, std::size_t> index_;
};

/// The instances of a scene, with their boxes relative to the camera.
struct InstanceList {
  ShapeList shapes;
  std::vector<Bounds> boxes;
  std::vector<double> steps;  // loop turns of a ray through the instance

  /// A mesh without triangles or under a singular transform is skipped.
  void add(const MeshPlace& mesh, const glm::dmat4& worldFromObject, const glm::dvec3& origin,
           SurfaceLink link);
  /// The hierarchy over the boxes: TOP_LEVEL_ROWS per node, the root first. No instance, no rows.
  std::vector<glm::vec4> topLevelRows() const;
  /// Loop turns of the worst of some rays through everything.
  double worstSteps() const;
};

}  // namespace steradian
