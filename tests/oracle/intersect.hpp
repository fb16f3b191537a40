// SPDX-License-Identifier: MIT
// Where a ray meets the analytic shapes, in double and by plain geometry.
#pragma once
#include <optional>

#include "tests/oracle/world.hpp"

namespace steradian::oracle {

struct Ray {
  dvec3 origin{0.0}, direction{0.0, 0.0, -1.0};  // direction of any length: parameters count in it

  dvec3 at(double t) const { return origin + t * direction; }
};

struct Hit {
  double t = 0.0;
  dvec3 normal{0.0};  // unit, outward for solids, the shape's +Y for flat ones
  const Body* body = nullptr;
  std::size_t triangle = 0;  // of a mesh
  dvec2 barycentric{0.0};    // weights of its second and third corner
};

/// First meeting of a ray with a shape in the shape's own frame at t > tMin; the normal is not of unit
/// length.
std::optional<Hit> intersect(const Shape& shape, const Ray& ray, double tMin);

/// The same for a placed shape, the normal in the world.
std::optional<Hit> intersect(const Body& body, const Ray& ray, double tMin);

/// The nearest of all, by trying every one.
std::optional<Hit> nearest(const World& world, const Ray& ray, double tMin);

/// Parameters below this are the surface that the ray starts on, for a ray with a unit direction.
double selfDistance(const dvec3& origin);

}  // namespace steradian::oracle
