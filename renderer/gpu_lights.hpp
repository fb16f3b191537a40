// SPDX-License-Identifier: MIT
// Lights -> rows (shaders/gpu_types.h): suns, then other punctual lights, then the emissive primitives that
// can be sampled.
#pragma once
#include <cstdint>
#include <vector>

#include "renderer/gpu_meshes.hpp"

namespace steradian {

class LightRows {
 public:
  /// A point, spot or directional light; others have bodies and come by addEmitter().
  void addPunctual(const Light& light, const glm::dmat4& world, const glm::dvec3& origin);
  /// A primitive that emits `radiance` (nit); its light index, or NO_LIGHT when its kind is left to the
  /// paths. Call after all punctual lights.
  std::uint32_t addEmitter(ShapeKind kind, const Placement& place, const glm::vec3& radiance, bool oneSided,
                           std::uint32_t primitive);

  /// The same for a box, cylinder or ellipsoid whose rows begin at `shapeRow`.
  std::uint32_t addSolid(ShapeKind kind, const Placement& place, const glm::vec3& radiance,
                         std::uint32_t primitive, std::uint32_t shapeRow);

  /// The same for an instance of a mesh within `box`.
  std::uint32_t addMesh(const MeshLight& mesh, const Bounds& box, const glm::vec3& radiance,
                        std::uint32_t primitive);

  std::uint32_t count() const;
  std::uint32_t sunCount() const;
  std::uint32_t features() const { return features_; }
  /// Bit i: some of kind LIGHT_BOX + i.
  std::uint32_t solids() const { return solids_; }
  /// Of the largest mesh among them; 0 = none.
  std::uint32_t mostTriangles() const { return mostTriangles_; }
  /// All rows in upload order.
  std::vector<glm::vec4> rows() const;

 private:
  /// A light whose shape is read where it lies: a solid or a mesh.
  struct Body {
    std::uint32_t kind;  // LIGHT_*
    Bounds box;
    double area;
    std::uint32_t row, triangles, primitive;
  };
  std::uint32_t addBody(const Body& body, const glm::vec3& radiance);

  std::vector<glm::vec4> suns_, others_;
  std::uint32_t features_ = 0, mostTriangles_ = 0, solids_ = 0;
};

}  // namespace steradian
