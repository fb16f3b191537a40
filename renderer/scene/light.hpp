// SPDX-License-Identifier: MIT
// Punctual lights in the photometric units of KHR_lights_punctual. A light shines along its object's -Z.
#pragma once
#include <variant>

#include <glm/glm.hpp>

namespace steradian {

struct PointLight {
  bool operator==(const PointLight&) const = default;
};
struct SpotLight {
  float innerConeAngle = 0.0f;        // radians, half angle of full intensity, < outer
  float outerConeAngle = 0.7853982f;  // radians, half angle where it ends, <= pi/2
  bool operator==(const SpotLight&) const = default;
};
struct DirectionalLight {
  bool operator==(const DirectionalLight&) const = default;
};

struct Light {
  std::variant<PointLight, SpotLight, DirectionalLight> kind;
  glm::vec3 color{1.0f};    // linear Rec. 709, >= 0
  float intensity = 10.0f;  // cd for point and spot, lx for directional, >= 0
  bool operator==(const Light&) const = default;
};

}  // namespace steradian
