// SPDX-License-Identifier: MIT
// Placement of an object relative to its parent, in double: the scene may be far from its origin.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace steradian {

struct Transform {
  glm::dvec3 translation{0.0};              // metres
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  // w, x, y, z; unit length
  glm::dvec3 scale{1.0};                    // factors along the local axes, not 0

  friend bool operator==(const Transform& a, const Transform& b) {
    return a.translation == b.translation && a.rotation == b.rotation && a.scale == b.scale;
  }
};

/// parentFromLocal = T * R * S.
glm::dmat4 matrixOf(const Transform& transform);
/// The nearest Transform: exact for T * R * S, a shear is dropped; a mirrored matrix gets a negative x scale.
Transform transformOf(const glm::dmat4& parentFromLocal);

}  // namespace steradian
