// SPDX-License-Identifier: MIT
// Node transforms: matrices and translation, rotation, scale.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "document.hpp"

namespace gltf {

struct Trs {
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  // unit
  glm::dvec3 scale{1.0};
};

glm::dmat4 matrixOf(const Trs& trs);

/// The nearest T * R * S; `sheared` when it is not the same matrix, `flat` when it squeezes space.
Trs decomposed(const glm::dmat4& matrix, bool& sheared);

/// What the node says of itself: its matrix, or its T, R and S with glTF's defaults.
glm::dmat4 matrixOf(const tinygltf::Node& node);
Trs trsOf(const tinygltf::Node& node, bool& sheared);

/// Just short of flat where it is flat: a scene has no object without an inverse.
glm::dvec3 awayFromZero(const glm::dvec3& scale);

}  // namespace gltf
