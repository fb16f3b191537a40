// SPDX-License-Identifier: MIT
// Meshes -> the rows that shaders read: built once per mesh, placed by instances.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include "renderer/gpu_shapes.hpp"
#include "renderer/mesh/bounds.hpp"
#include "renderer/mesh_cache.hpp"

namespace steradian {

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

/// An instance as a light.
struct MeshLight {
  std::uint32_t triangleRow = 0, triangles = 0;
  double area = 0.0;  // square metres; of a mesh that is stretched a guess
};

/// The instances of a scene, with their boxes relative to the camera.
struct InstanceList {
  ShapeList shapes;
  std::vector<Bounds> boxes;
  std::vector<MeshLight> lights;
  std::vector<double> steps;  // loop turns of a ray through the instance

  /// A mesh without triangles or under a singular transform is skipped.
  void add(const MeshPlace& mesh, const glm::dmat4& worldFromObject, const glm::dvec3& origin,
           SurfaceLink link);
};

}  // namespace steradian
