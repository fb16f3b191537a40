// SPDX-License-Identifier: MIT
// Pinhole camera: looks along its object's -Z, +Y up.
#pragma once
#include <glm/glm.hpp>

namespace steradian {

struct Camera {
  double fovY = 0.7853982;  // radians, full vertical angle, in (0, pi)
  bool operator==(const Camera&) const = default;
};

/// A placed camera, what the renderer looks through: the scene's or the editor's free one.
struct CameraView {
  glm::dmat4 worldFromCamera{1.0};  // rigid
  double fovY = 0.7853982;          // radians, full vertical angle
  bool operator==(const CameraView&) const = default;
};

}  // namespace steradian
