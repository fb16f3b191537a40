// SPDX-License-Identifier: MIT
// Integrals of the lights' emission over their surfaces and directions.
#include "editor/photometry.hpp"

#include <algorithm>
#include <cmath>

namespace steradian {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Flux and axial intensity of a light of strength 1; nullopt where undefined.
struct Output {
  double flux, ahead;
};

struct OutputOf {
  glm::dvec3 x, y, z;  // the object's axes in the world

  std::optional<Output> operator()(const PointLight&) const { return Output{4.0 * kPi, 1.0}; }
  /// The intensity falls from the inner to the outer cone as KHR_lights_punctual recommends:
  /// clamp((cos t - cos outer) / (cos inner - cos outer), 0, 1)^2.
  std::optional<Output> operator()(const SpotLight& spot) const {
    const double inner = std::cos(spot.innerConeAngle), outer = std::cos(spot.outerConeAngle);
    return Output{2.0 * kPi * ((1.0 - inner) + (inner - outer) / 3.0), 1.0};
  }
  std::optional<Output> operator()(const DirectionalLight&) const { return std::nullopt; }
  std::optional<Output> operator()(const SphereLight& light) const {
    const double a = glm::length(x), b = glm::length(y), c = glm::length(z);
    const double least = std::min({a, b, c}), most = std::max({a, b, c});
    if (most > least * (1.0 + 1e-6)) return std::nullopt;
    const double area = kPi * light.radius * light.radius * a * a;  // as seen from anywhere
    return Output{4.0 * kPi * area, area};
  }
  std::optional<Output> operator()(const RectLight& light) const {
    return lambertian(light.size.x * light.size.y);
  }
  std::optional<Output> operator()(const DiskLight& light) const {
    return lambertian(kPi * light.radius * light.radius);
  }
  std::optional<Output> operator()(const EnvironmentLight&) const { return std::nullopt; }

 private:
  /// One side of a flat surface of this area in the object's XY plane.
  std::optional<Output> lambertian(double objectArea) const {
    const double area = objectArea * glm::length(glm::cross(x, y));
    return Output{kPi * area, area};
  }
};

std::optional<Output> outputOf(const Light& light, const glm::dmat4& m) {
  std::optional<Output> unit =
      std::visit(OutputOf{glm::dvec3(m[0]), glm::dvec3(m[1]), glm::dvec3(m[2])}, light.kind);
  if (!unit) return std::nullopt;
  const double strength = double(light.intensity) * luminanceOf(lightColor(light));
  return Output{unit->flux * strength, unit->ahead * strength};
}

}  // namespace

double luminanceOf(const glm::vec3& linear) {
  return 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z;
}

std::optional<double> luminousFlux(const Light& light, const glm::dmat4& worldFromObject) {
  const auto output = outputOf(light, worldFromObject);
  return output ? std::optional(output->flux) : std::nullopt;
}

std::optional<double> intensityAhead(const Light& light, const glm::dmat4& worldFromObject) {
  const auto output = outputOf(light, worldFromObject);
  return output ? std::optional(output->ahead) : std::nullopt;
}

}  // namespace steradian
