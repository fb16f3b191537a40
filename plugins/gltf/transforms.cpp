// SPDX-License-Identifier: MIT
// Node transforms: matrices and translation, rotation, scale.
#include "transforms.hpp"

#include <cmath>

namespace gltf {

namespace {

constexpr double kFlattest = 1e-9;

glm::dvec3 anyPerpendicular(const glm::dvec3& unit) {
  const glm::dvec3 other = std::abs(unit.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(unit, other));
}

glm::dquat unit(const glm::dquat& q) {
  const double length = glm::length(q);
  return length > 1e-12 ? q / length : glm::dquat(1, 0, 0, 0);
}

}  // namespace

glm::dmat4 matrixOf(const Trs& trs) {
  const glm::dmat3 rotation = glm::mat3_cast(trs.rotation);
  glm::dmat4 out(1.0);
  for (int c = 0; c < 3; ++c) out[c] = glm::dvec4(rotation[c] * trs.scale[c], 0.0);
  out[3] = glm::dvec4(trs.translation, 1.0);
  return out;
}

Trs decomposed(const glm::dmat4& matrix, bool& sheared) {
  const glm::dmat3 m(matrix);
  Trs out;
  out.translation = glm::dvec3(matrix[3]);
  // Gram-Schmidt from X on; a missing axis is taken from the others.
  glm::dmat3 axes(0.0);
  for (int c = 0; c < 3; ++c) {
    glm::dvec3 axis = m[c];
    for (int before = 0; before < c; ++before) axis -= glm::dot(axes[before], axis) * axes[before];
    const bool flat = glm::length(axis) <= 1e-9 * glm::length(m[c]) || glm::length(axis) == 0.0;
    if (!flat)
      axes[c] = glm::normalize(axis);
    else
      axes[c] = c == 2   ? glm::cross(axes[0], axes[1])
                : c == 1 ? anyPerpendicular(axes[0])
                         : glm::dvec3(1, 0, 0);
    out.scale[c] = glm::dot(axes[c], m[c]);
  }
  if (glm::determinant(axes) < 0.0) axes[2] = -axes[2], out.scale[2] = -out.scale[2];
  out.rotation = unit(glm::quat_cast(axes));
  const glm::dmat4 back = matrixOf(out);
  double difference = 0.0, size = 0.0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) {
      difference = std::max(difference, std::abs(back[c][r] - matrix[c][r]));
      size = std::max(size, std::abs(matrix[c][r]));
    }
  sheared = difference > 1e-5 * size;
  return out;
}

glm::dmat4 matrixOf(const tinygltf::Node& node) {
  if (node.matrix.size() != 16) {
    bool none;
    return matrixOf(trsOf(node, none));
  }
  glm::dmat4 out;
  for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = node.matrix[std::size_t(i)];
  return out;
}

Trs trsOf(const tinygltf::Node& node, bool& sheared) {
  sheared = false;
  if (node.matrix.size() == 16) return decomposed(matrixOf(node), sheared);
  const auto &t = node.translation, &r = node.rotation, &s = node.scale;
  Trs out;
  if (t.size() == 3) out.translation = {t[0], t[1], t[2]};
  if (r.size() == 4) out.rotation = unit(glm::dquat(r[3], r[0], r[1], r[2]));
  if (s.size() == 3) out.scale = {s[0], s[1], s[2]};
  return out;
}

glm::dvec3 awayFromZero(const glm::dvec3& scale) {
  glm::dvec3 out = scale;
  for (int i = 0; i < 3; ++i)
    if (std::abs(out[i]) < kFlattest) out[i] = std::copysign(kFlattest, out[i]);
  return out;
}

}  // namespace gltf
