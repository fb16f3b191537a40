// SPDX-License-Identifier: MIT
// Orbiting, panning, zooming and framing.
#include "editor/ui/navigation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steradian::ui {

namespace {

constexpr double kPitchLimit = 0.5 * std::numbers::pi - 1e-3;  // yaw is undefined straight up
constexpr double kMinDistance = 1e-6, kMaxDistance = 1e12;

}  // namespace

glm::dmat3 OrbitView::axes() const {
  const glm::dvec3 backward(std::cos(pitch_) * std::sin(yaw_), -std::sin(pitch_),
                            std::cos(pitch_) * std::cos(yaw_));
  const glm::dvec3 right(std::cos(yaw_), 0.0, -std::sin(yaw_));
  return {right, glm::cross(backward, right), backward};
}

CameraView OrbitView::view() const {
  const glm::dmat3 basis = axes();
  glm::dmat4 world(basis);
  world[3] = glm::dvec4(pivot_ + distance_ * basis[2], 1.0);
  return {world, fovY_, {}};
}

void OrbitView::lookAs(const CameraView& view, double distance) {
  const glm::dvec3 backward = glm::normalize(glm::dvec3(view.worldFromCamera[2]));
  pitch_ = std::clamp(std::asin(std::clamp(-backward.y, -1.0, 1.0)), -kPitchLimit, kPitchLimit);
  if (std::hypot(backward.x, backward.z) > 1e-9) yaw_ = std::atan2(backward.x, backward.z);
  fovY_ = view.fovY;
  distance_ = std::clamp(distance, kMinDistance, kMaxDistance);
  pivot_ = glm::dvec3(view.worldFromCamera[3]) - distance_ * axes()[2];
}

void OrbitView::setPivotDistance(double distance) {
  const glm::dvec3 backward = axes()[2];
  const glm::dvec3 eye = pivot_ + distance_ * backward;
  distance_ = std::clamp(distance, kMinDistance, kMaxDistance);
  pivot_ = eye - distance_ * backward;
}

void OrbitView::orbit(double right, double down) {
  yaw_ = std::remainder(yaw_ - right * std::numbers::pi, 2.0 * std::numbers::pi);
  pitch_ = std::clamp(pitch_ - down * std::numbers::pi, -kPitchLimit, kPitchLimit);
}

void OrbitView::pan(double right, double down) {
  const double metresPerHeight = 2.0 * distance_ * std::tan(0.5 * fovY_);
  const glm::dmat3 basis = axes();
  pivot_ += metresPerHeight * (-right * basis[0] + down * basis[1]);
}

void OrbitView::zoom(double steps) {
  distance_ = std::clamp(distance_ * std::pow(0.88, steps), kMinDistance, kMaxDistance);
}

void OrbitView::frame(const Bounds& bounds, double aspect) {
  pivot_ = bounds.center();
  const double radius = bounds.radius() > 0.0 ? bounds.radius() : 0.25 * distance_;
  const double halfAngle = 0.5 * fovY_;
  const double narrow = std::min(halfAngle, std::atan(std::tan(halfAngle) * aspect));
  distance_ = std::clamp(1.05 * radius / std::sin(narrow), kMinDistance, kMaxDistance);
}

}  // namespace steradian::ui
