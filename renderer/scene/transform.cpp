// SPDX-License-Identifier: MIT
// Transform to matrix and back.
#include "renderer/scene/transform.hpp"

#include <algorithm>

namespace steradian {

namespace {
/// `v` at length 1, or `otherwise` when it has no direction.
glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : otherwise;
}
}  // namespace

glm::dmat4 matrixOf(const Transform& transform) {
  glm::dmat4 matrix = glm::mat4_cast(transform.rotation);
  matrix[0] *= transform.scale.x;
  matrix[1] *= transform.scale.y;
  matrix[2] *= transform.scale.z;
  matrix[3] = glm::dvec4(transform.translation, 1.0);
  return matrix;
}

Transform transformOf(const glm::dmat4& parentFromLocal) {
  const glm::dmat3 linear(parentFromLocal);
  // Gram-Schmidt from Z, so that a camera's viewing direction survives a shear.
  const glm::dvec3 z = unitOr(linear[2], {0.0, 0.0, 1.0});
  const glm::dvec3 anyY = std::abs(z.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 y =
      unitOr(linear[1] - z * glm::dot(z, linear[1]), glm::normalize(anyY - z * glm::dot(z, anyY)));
  const glm::dvec3 x = glm::cross(y, z);
  Transform transform;
  transform.translation = glm::dvec3(parentFromLocal[3]);
  transform.rotation = glm::normalize(glm::quat_cast(glm::dmat3(x, y, z)));
  transform.scale = {glm::dot(x, linear[0]), glm::length(linear[1]), glm::length(linear[2])};
  return transform;
}

}  // namespace steradian
