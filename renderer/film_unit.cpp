// SPDX-License-Identifier: MIT
#include "renderer/film_unit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/display.hpp"

namespace steradian {
namespace {

constexpr double unitPerWhite = 4096.0, mostSamples = 1 << 20;
// The unit's inverse and its smallest digit are floats, too.
constexpr int leastExponent = -60, mostExponent = 90;

float brightest(const glm::vec4& row) {
  return std::max({row.x, row.y, row.z});
}

/// Of all textures, whatever they are for: only those of half floats go beyond 1.
float brightestTexture(const GpuScene& scene) {
  float most = 1.0f;
  for (const auto& texture : scene.textures) most = std::max(most, texture->brightest);
  return most;
}

}  // namespace

float brightestEmission(const GpuScene& scene, float brightestTexel) {
  const gpu::TraceParams& p = scene.params;
  const float textured = brightestTexture(scene);
  float most = 0.0f;
  for (std::uint32_t row = p.materialRow; row < p.objectRow; row += gpu::MATERIAL_ROWS)
    most = std::max(most, brightest(scene.rows[row + 2]) * textured);
  for (std::uint32_t i = 0; i < p.sunCount; ++i) {
    const glm::vec4& illuminance = scene.rows[p.lightRow + i * gpu::LIGHT_ROWS + 1];
    const float solidAngle = 2.0f * std::numbers::pi_v<float> * illuminance.w;
    most = std::max(most, brightest(illuminance) / solidAngle);
  }
  for (std::uint32_t i = 0; i < 3; ++i)  // zenith, horizon, ground
    most = std::max(most, brightest(scene.rows[p.environmentRow + i]) * brightestTexel);
  return most;
}

float filmUnit(float brightestEmission, const DisplaySettings& display) {
  const double white = 1.0 / exposureScaleOf(display);
  const double least = std::max(white * unitPerWhite, brightestEmission * mostSamples / gpu::FILM_BASE);
  if (!(least < std::ldexp(1.0, mostExponent))) return std::ldexp(1.0f, mostExponent);
  return float(std::exp2(std::ceil(std::max(std::log2(least), double(leastExponent)))));
}

}  // namespace steradian
