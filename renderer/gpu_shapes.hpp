// SPDX-License-Identifier: MIT
// Analytic shapes -> rows, one list per kind in upload order.
#pragma once
#include <optional>
#include <vector>

#include "renderer/gpu_scene.hpp"

namespace steradian {

/// What a primitive belongs to.
struct SurfaceLink {
  Id material;
  Id object;
  const Light* light = nullptr;                   // the primitive is this area light's body
  std::optional<std::uint32_t> vertexFlags = {};  // of meshes: MESH_*
};

/// Where a primitive is: its unit shape in camera-relative world axes.
struct Placement {
  glm::dmat3 worldFromUnit;
  glm::dvec3 centre;
};

struct ShapeList {
  std::vector<glm::vec4> rows;
  std::vector<SurfaceLink> links;  // one per primitive
  std::vector<Placement> places;   // one per primitive
};

/// Kinds in upload order.
enum ShapeKind {
  spheres,
  planes,
  largeSpheres,
  boxes,
  rects,
  disks,
  cylinders,
  ellipsoids,
  instances,
  shapeKinds
};

struct ShapeLists {
  ShapeList kinds[shapeKinds];
  /// `worldFromObject` relative to nothing; `origin` is subtracted in double. Shapes without extent are
  /// skipped.
  void add(const Shape& shape, const glm::dmat4& worldFromObject, const glm::dvec3& origin, SurfaceLink link,
           double largeRadius);
  /// The body of a sphere, rect or disk light; nothing for others.
  void addLight(const Light& light, const glm::dmat4& worldFromObject, const glm::dvec3& origin, Id object,
                double largeRadius);
};

/// World radius of a sphere under a uniformly scaling transform; nothing when it is stretched to an
/// ellipsoid.
std::optional<double> sphereRadius(const Sphere& sphere, const glm::dmat4& worldFromObject);
/// The smallest length of a bounded shape in the world, infinity for planes.
double smallestExtent(const Shape& shape, const glm::dmat4& worldFromObject);

}  // namespace steradian
