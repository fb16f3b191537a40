// SPDX-License-Identifier: MIT
// The shapes: analytic ones, each centred at its object's origin, sizes in metres before the object's
// transform; and meshes.
#pragma once
#include <variant>

#include <glm/glm.hpp>

#include "renderer/scene/ids.hpp"
#include "renderer/scene/mesh.hpp"

namespace steradian {

struct Sphere {
  double radius = 1.0;
  bool operator==(const Sphere&) const = default;
};
/// Infinite, through the origin, normal +Y.
struct Plane {
  bool operator==(const Plane&) const = default;
};
struct Box {
  glm::dvec3 size{2.0};
  bool operator==(const Box&) const = default;
};  // full edge lengths
struct Rect {
  glm::dvec2 size{2.0};
  bool operator==(const Rect&) const = default;
};  // full lengths along X and Z, normal +Y
struct Disk {
  double radius = 1.0;
  bool operator==(const Disk&) const = default;
};  // in XZ, normal +Y
struct Cylinder {
  double radius = 1.0;
  double height = 2.0;
  bool operator==(const Cylinder&) const = default;
};  // axis Y, capped

using Shape = std::variant<Sphere, Plane, Box, Rect, Disk, Cylinder, MeshShape>;

/// An object's visible surface: a shape and the material on it (Id::none = the default material).
struct Geometry {
  Shape shape;
  Id material = Id::none;
  bool operator==(const Geometry&) const = default;
};

}  // namespace steradian
