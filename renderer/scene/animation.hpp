// SPDX-License-Identifier: MIT
// Keyed animation of transforms and lights; evaluation gives a plain scene at one time.
#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "renderer/scene/ids.hpp"

namespace steradian {

enum class Property { translation, rotation, scale, lightIntensity, lightColor };
enum class Interpolation {
  step,
  linear,
  cubic
};  // cubic = Catmull-Rom through the keys; rotations use slerp for both

struct Keyframe {
  double time = 0.0;      // seconds
  glm::dvec4 value{0.0};  // xyz; rotation: x, y, z, w; intensity: x
  bool operator==(const Keyframe&) const = default;
};

struct Channel {
  Id target = Id::none;  // object
  Property property = Property::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<Keyframe> keys;  // strictly increasing times; held before the first and after the last
  bool operator==(const Channel&) const = default;
};

struct Animation {
  double framesPerSecond = 24.0;
  std::vector<Channel> channels;
  bool operator==(const Animation&) const = default;
};

}  // namespace steradian
