// SPDX-License-Identifier: MIT
// Cameras look along their object's -Z, +Y up: through a pinhole, a thin lens, or in parallel.
#pragma once
#include <cstdint>

#include <glm/glm.hpp>

namespace steradian {

enum class Projection : std::uint32_t { perspective = 0, orthographic = 1 };

struct Camera {
  double fovY = 0.7853982;  // radians, full vertical angle, in (0, pi)
  Projection projection = Projection::perspective;
  double orthographicHeight = 2.0;  // metres, full height of the view; orthographic only
  double fNumber = 0.0;             // focal length / aperture diameter, >= 0; 0 = pinhole, all in focus
  double focusDistance = 5.0;       // metres along the view axis to the plane in focus, > 0
  bool operator==(const Camera&) const = default;
};

/// Height of the imaginary sensor, which turns field of view and f-number into a lens: full frame.
inline constexpr double kSensorHeightMetres = 0.024;
/// Radius in metres of the lens opening; 0 for a pinhole and in parallel projection.
double apertureRadius(const Camera& camera);

/// A placed camera, what the renderer looks through: the scene's or the editor's free one.
struct CameraView {
  glm::dmat4 worldFromCamera{1.0};  // rigid
  double fovY = 0.7853982;          // radians, full vertical angle
  Camera lens;                      // all else of the camera; its own fovY is not used
  bool operator==(const CameraView&) const = default;
};

}  // namespace steradian
