// SPDX-License-Identifier: MIT
#include "renderer/scene/inside.hpp"

#include <cmath>

namespace steradian {

bool holdsInside(const Shape& shape, const glm::dmat4& worldFromObject, const glm::dvec3& point) {
  const glm::dvec3 p(glm::inverse(worldFromObject) * glm::dvec4(point, 1.0));
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return glm::length(p) < sphere->radius;
  if (const auto* box = std::get_if<Box>(&shape))
    return glm::all(glm::lessThan(glm::abs(p), 0.5 * glm::abs(box->size)));
  if (const auto* cylinder = std::get_if<Cylinder>(&shape))
    return std::hypot(p.x, p.z) < cylinder->radius && std::abs(p.y) < 0.5 * cylinder->height;
  return std::holds_alternative<Plane>(shape) && p.y < 0.0;
}

}  // namespace steradian
