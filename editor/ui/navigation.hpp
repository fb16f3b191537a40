// SPDX-License-Identifier: MIT
// The editor's own eye: orbits a pivot, in double so that scenes far from the origin work.
#pragma once
#include <glm/glm.hpp>

#include "editor/bounds.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian::ui {

class OrbitView {
 public:
  CameraView view() const;
  double distance() const { return distance_; }
  glm::dvec3 pivot() const { return pivot_; }

  /// Looks as `view` does, with the pivot `distance` metres ahead; a roll about the view axis is dropped.
  void lookAs(const CameraView& view, double distance);
  void setPivotDistance(double distance);  // the eye stays where it is

  // Mouse motion in fractions of the viewport's height.
  void orbit(double right, double down);
  void pan(double right, double down);
  void zoom(double steps);  // of the wheel, positive = closer

  /// Keeps the direction and brings the box into view.
  void frame(const Bounds& bounds, double aspect);

 private:
  glm::dmat3 axes() const;  // columns: right, up, backward

  glm::dvec3 pivot_{0.0, 1.0, 0.0};
  double distance_ = 6.0;
  double yaw_ = 0.6, pitch_ = -0.35;  // radians; yaw about +Y, pitch above the horizon
  double fovY_ = 0.7853982;
};

}  // namespace steradian::ui
