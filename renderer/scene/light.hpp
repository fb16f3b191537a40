// SPDX-License-Identifier: MIT
// Lights in photometric SI. A light shines along its object's -Z.
#pragma once
#include <memory>
#include <string>
#include <variant>

#include <glm/glm.hpp>

#include "renderer/scene/image.hpp"

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
  float angularDiameter = 0.0f;  // radians, [0, pi/2]; the sun's is 0.0093
  bool operator==(const DirectionalLight&) const = default;
};

// Area lights are visible, black bodies that emit `intensity` nit: from all of a sphere, from the -Z side of
// the others. They scale with their object.
struct SphereLight {
  double radius = 0.25;  // metres
  bool operator==(const SphereLight&) const = default;
};
struct RectLight {
  glm::dvec2 size{1.0};  // metres, full lengths along X and Y
  bool operator==(const RectLight&) const = default;
};
struct DiskLight {
  double radius = 0.5;  // metres, in XY
  bool operator==(const DiskLight&) const = default;
};

/// The sky around everything: a vertical gradient, times an equirectangular image when there is one (its
/// centre column along -Z, +Y up, turned by the object's rotation). A scene shows its first visible
/// environment.
struct EnvironmentLight {
  glm::vec3 horizon{1.0f};  // factors of the light's colour at the horizon and below; the zenith has factor 1
  glm::vec3 ground{1.0f};
  std::string file;                    // EXR or HDR image, relative to the project's folder; empty = none
  std::shared_ptr<const Image> image;  // its pixels, 3 channels, >= 0; null until loaded
  bool operator==(const EnvironmentLight&) const = default;  // pixels by identity
};

struct Light {
  std::variant<PointLight, SpotLight, DirectionalLight, SphereLight, RectLight, DiskLight, EnvironmentLight>
      kind;
  glm::vec3 color{1.0f};    // linear Rec. 709, >= 0
  float intensity = 10.0f;  // cd for point and spot, lx for directional, nit for the others, >= 0
  float temperature =
      0.0f;  // kelvin, 1000..40000: a black body's colour of luminance 1, times color; 0 = off
  bool operator==(const Light&) const = default;
};

/// Linear Rec. 709 of a light: color, times the black body's when it has a temperature.
glm::vec3 lightColor(const Light& light);

}  // namespace steradian
