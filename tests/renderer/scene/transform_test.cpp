// SPDX-License-Identifier: MIT
// Transform to matrix and back.
#include "renderer/scene/transform.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

using namespace steradian;

namespace {
void expectNear(const glm::dmat4& a, const glm::dmat4& b, double tolerance) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) EXPECT_NEAR(a[column][row], b[column][row], tolerance);
}
const glm::dquat kTilted = glm::normalize(glm::dquat(0.3, -0.5, 0.7, 0.2));
}  // namespace

TEST(Transform, scales_first_then_rotates_then_translates) {
  const Transform t{{10, 0, 0}, glm::angleAxis(glm::half_pi<double>(), glm::dvec3(0, 1, 0)), {2, 3, 4}};
  const glm::dvec4 p = matrixOf(t) * glm::dvec4(1, 1, 0, 1);  // (2, 3, 0), then +X turns to -Z
  EXPECT_NEAR(p.x, 10.0, 1e-15);
  EXPECT_NEAR(p.y, 3.0, 1e-15);
  EXPECT_NEAR(p.z, -2.0, 1e-15);
}

TEST(Transform, survives_the_way_to_a_matrix_and_back) {
  for (const glm::dvec3 scale : {glm::dvec3(1), glm::dvec3(1e-6, 2, 1e6), glm::dvec3(-1, 2, 3),
                                 glm::dvec3(1, -2, 3), glm::dvec3(1, 2, -3), glm::dvec3(-1, -2, -3)}) {
    const glm::dmat4 matrix = matrixOf({{1e6, -2, 3}, kTilted, scale});
    expectNear(matrixOf(transformOf(matrix)), matrix, 1e-9);
  }
}

TEST(Transform, of_a_sheared_matrix_has_unit_rotation_and_keeps_the_viewing_axis) {
  glm::dmat4 sheared = matrixOf({{}, kTilted, {1, 2, 3}});
  sheared[0] += 0.5 * sheared[2];
  const Transform t = transformOf(sheared);
  EXPECT_NEAR(glm::length(t.rotation), 1.0, 1e-15);
  EXPECT_NEAR(
      glm::length(glm::cross(t.rotation * glm::dvec3(0, 0, 1), glm::normalize(glm::dvec3(sheared[2])))), 0,
      1e-15);
}
