// SPDX-License-Identifier: MIT
// Random and hard inputs of every function whose rounding is measured: grazing, tiny roughness, far, huge.
#pragma once
#include <array>

#include "tests/shaders/kernel.hpp"

namespace steradian::kernel {

using Question = std::array<glm::vec4, 5>;

inline glm::vec4 rowOf(const glm::dvec3& v, double w = 0.0) {
  return glm::vec4(glm::vec3(v), float(w));
}

/// Unit, above the horizon, down to a cosine of 1e-4.
inline glm::dvec3 aboveHorizon(Random& random) {
  const double z = random.uniform() < 0.5 ? random.uniform(1e-4, 1.0) : random.decades(-4, 0);
  const double phi = random.uniform(0.0, 2.0 * M_PI), r = std::sqrt(1.0 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// A ray from up to 1e4 away towards a point within 1.2 radii of a target at the origin's neighbourhood.
struct Aim {
  glm::dvec3 o, d, target;
};
inline Aim aim(Random& random, double radius, double nearest, double farthest) {
  const glm::dvec3 target = random.direction() * random.decades(-2, 2);
  const glm::dvec3 o = target + random.direction() * radius * random.decades(nearest, farthest);
  const glm::dvec3 at = target + random.direction() * radius * 1.2 * random.uniform();
  return {o, glm::normalize(at - o), target};
}

inline Question sphereQuestion(Random& random) {
  const double radius = random.decades(-3, 2);
  const Aim a = aim(random, radius, -1, 4);
  return {rowOf(a.o), rowOf(a.d), rowOf(a.target, radius)};
}

// A planet under the camera, its centre known as a double-float.
inline Question largeSphereQuestion(Random& random) {
  const double radius = random.decades(2, 7);
  const glm::dvec3 up = random.direction(), centre = up * -(radius + random.decades(-2, 2));
  const glm::vec4 high = rowOf(centre, radius);
  return {rowOf(random.direction() * random.decades(-3, 0)), rowOf(random.direction()), high,
          rowOf(centre - glm::dvec3(high), radius - double(high.w))};
}

inline Question planeQuestion(Random& random) {
  const glm::vec3 n(random.direction());
  return {rowOf(random.direction() * random.decades(-2, 4)), rowOf(random.direction()),
          rowOf(glm::dvec3(n), random.decades(-2, 4))};
}

inline Question affineQuestion(Random& random) {
  const Aim a = aim(random, 1.0, -1, 3);
  const glm::dvec3 x = random.direction(), y = glm::normalize(glm::cross(x, random.direction()));
  const glm::dvec3 z = glm::cross(x, y),
                   size(random.decades(-1, 1), random.decades(-1, 1), random.decades(-1, 1));
  return {rowOf(a.o), rowOf(a.d), rowOf(x * size.x, a.target.x), rowOf(y * size.y, a.target.y),
          rowOf(z * size.z, a.target.z)};
}

inline Question scatteringQuestion(Random& random) {
  const double alpha = random.decades(-3, 0);
  const glm::dvec3 wo = aboveHorizon(random);
  // Half of the pairs lie in the lobe, where the density is.
  glm::dvec3 wi = aboveHorizon(random);
  if (random.uniform() < 0.5) {
    const glm::dvec3 h =
        glm::normalize(glm::dvec3(0, 0, 1) + random.direction() * alpha * random.uniform(0.0, 3.0));
    const glm::dvec3 mirrored = h * (2.0 * glm::dot(wo, h)) - wo;
    if (mirrored.z > 1e-4) wi = mirrored;
  }
  return {rowOf(wo, alpha), rowOf(wi, random.uniform() < 0.5 ? 1.5 : 1.0 / 1.5),
          glm::vec4(float(random.uniform()), float(random.uniform()), 0, 0)};
}

inline Question directionQuestion(Random& random) {
  return {rowOf(random.direction())};
}

inline Question heuristicQuestion(Random& random) {
  return {glm::vec4(0, 0, 0, float(random.decades(-15, 15))),
          glm::vec4(0, 0, 0, float(random.decades(-15, 15)))};
}

// A light of about 1 m seen from 0.1 to 1,000 m, at all angles.
inline Question lightQuestion(Random& random) {
  const glm::dvec3 centre = random.direction() * random.decades(-1, 1);
  const glm::dvec3 x = random.direction(), y = glm::normalize(glm::cross(x, random.direction()));
  const double radius = random.decades(-2, 0);
  const glm::dvec3 p = centre + random.direction() * radius * random.decades(0.1, 3);
  return {rowOf(p, random.uniform()), rowOf(centre, random.uniform()),
          rowOf(x * radius * random.uniform(0.2, 1.0), radius), rowOf(y * radius * random.uniform(0.2, 1.0))};
}

}  // namespace steradian::kernel
