// SPDX-License-Identifier: MIT
// Light rows as shaders/gpu_types.h lays them out, and what they should answer, in long double.
#pragma once
#include <bit>
#include <cmath>

#include "renderer/light_tree.hpp"
#include "shaders/gpu_types.h"
#include "tests/shaders/kernel.hpp"
#include "tests/shaders/oracle.hpp"

namespace steradian::kernel {

using glm::dvec3;
using glm::vec3;
using oracle::Real;
using oracle::Vec;

inline constexpr std::uint32_t testPrimitive = 7;

inline glm::vec4 row(const vec3& v, std::uint32_t kind) {
  return glm::vec4(v, float(kind));
}
inline glm::vec4 bitsRow(const vec3& v, std::uint32_t bits) {
  return glm::vec4(v, std::bit_cast<float>(bits));
}

inline Rows pointLight(const vec3& at, float candela) {
  return {row(at, gpu::LIGHT_POINT), glm::vec4(vec3(candela), 0), glm::vec4(0), glm::vec4(0)};
}
/// Half angle 0: parallel light.
inline Rows directionalLight(const vec3& towards, float lux, double halfAngle = 0.0) {
  const double s = std::sin(0.5 * halfAngle);
  return {row(towards, gpu::LIGHT_DIRECTIONAL), glm::vec4(vec3(lux), float(2 * s * s)), glm::vec4(0),
          glm::vec4(0)};
}
inline Rows sphereLight(const vec3& centre, float nit, float radius) {
  return {row(centre, gpu::LIGHT_SPHERE), glm::vec4(vec3(nit), radius), glm::vec4(0),
          bitsRow(vec3(0), testPrimitive)};
}
/// A rect (half edges) or disk (semi-axes).
inline Rows flatLight(std::uint32_t kind, const vec3& centre, float nit, const vec3& u, const vec3& v,
                      bool bothSides = false) {
  return {row(centre, kind), glm::vec4(vec3(nit), bothSides ? 1.0f : 0.0f), glm::vec4(u, 0),
          bitsRow(v, testPrimitive)};
}

/// A scene of lights and their tree, of which `samples` are sampled at a vertex.
inline Task lightTask(std::uint32_t operation, std::size_t rowsIn, std::size_t rowsOut, Rows lights,
                      std::uint32_t samples = 1) {
  gpu::TraceParams params{};
  params.lightCount = std::uint32_t(lights.size() / gpu::LIGHT_ROWS);
  params.lightSamples = samples;
  params.lightTreeRow = std::uint32_t(lights.size());
  const Rows tree = lightTreeRows(lights);
  lights.insert(lights.end(), tree.begin(), tree.end());
  return {.operation = operation,
          .rowsIn = rowsIn,
          .rowsOut = rowsOut,
          .push = pushBytes(params),
          .scene = std::move(lights)};
}

/// A rect in its own axes around a point.
struct SeenRect {
  Real x0, x1, y0, y1, z;
  Vec ex, ey;

  SeenRect(const Rows& light, const Vec& p) {
    const Vec f = Vec(xyz(light[0])) - p, u(xyz(light[2])), v(xyz(light[3]));
    const Real lu = glm::length(u), lv = glm::length(v);
    ex = u / lu;
    ey = v / lv;
    const Real x = glm::dot(f, ex), y = glm::dot(f, ey);
    x0 = x - lu, x1 = x + lu, y0 = y - lv, y1 = y + lv;
    z = std::fabs(glm::dot(f, glm::normalize(glm::cross(u, v))));
  }
  /// Solid angle of [0, x] x [0, y], signed.
  Real corner(Real x, Real y) const { return std::atan2(x * y, z * std::sqrt(x * x + y * y + z * z)); }
  Real solidAngle(Real xa, Real xb, Real ya, Real yb) const {
    return corner(xb, yb) - corner(xa, yb) - corner(xb, ya) + corner(xa, ya);
  }
  Real solidAngle() const { return solidAngle(x0, x1, y0, y1); }
};

}  // namespace steradian::kernel
