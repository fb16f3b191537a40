// SPDX-License-Identifier: MIT
// Random and hard inputs of every function whose rounding is measured: grazing, tiny roughness, far, huge.
#pragma once
#include <array>
#include <bit>

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

/// A triangle around a point from 1.3 to 1e3 sizes away.
inline Question glowingTriangleQuestion(Random& random) {
  const double size = random.decades(-2, 1);
  const glm::dvec3 corner = random.direction() * (size * random.decades(0.1, 3));
  const glm::dvec3 edge1 = random.direction() * size * random.uniform(0.2, 1.0);
  const glm::dvec3 edge2 = random.direction() * size * random.uniform(0.2, 1.0);
  return {rowOf(corner, random.uniform()), rowOf(edge1, random.uniform()), rowOf(edge2)};
}

/// A ray at a point of the triangle's neighbourhood: corners around `target` within `size`, from up to 1e3
/// sizes away.
inline Question triangleAt(Random& random, const glm::dvec3& normal, double size, double thickness,
                           double elevation) {
  const glm::dvec3 target = random.direction() * random.decades(-2, 2);
  const glm::dvec3 x = glm::normalize(glm::cross(normal, random.direction())), y = glm::cross(normal, x);
  const auto corner = [&](double turn) {
    const double r = size * random.uniform(0.3, 1.0);
    return target + x * (r * std::cos(turn)) + y * (r * thickness * std::sin(turn));
  };
  const double turn = random.uniform(0.0, 2.0 * M_PI);
  const glm::dvec3 a = corner(turn), b = corner(turn + 2.0), c = corner(turn + 4.2);
  const double u = random.uniform(-0.2, 1.2), v = random.uniform(-0.2, 1.2);
  const glm::dvec3 at = a + (b - a) * u + (c - a) * v;
  const glm::dvec3 level = glm::normalize(x * random.uniform(-1, 1) + y * random.uniform(-1, 1));
  const glm::dvec3 away = level * std::sqrt(1.0 - elevation * elevation) + normal * elevation;
  const glm::dvec3 o = at + away * (size * random.decades(-1, 3));
  return {rowOf(o), rowOf(glm::normalize(at - o)), rowOf(a), rowOf(b), rowOf(c)};
}

// Sizes from 1 mm to 100 m, seen at any angle above 6 degrees, and aimed at a little more than the triangle.
inline Question triangleQuestion(Random& random) {
  return triangleAt(random, random.direction(), random.decades(-3, 2), 1.0, random.uniform(0.1, 1.0));
}
// A hundredth as wide as long.
inline Question sliverQuestion(Random& random) {
  return triangleAt(random, random.direction(), random.decades(-1, 1), 0.01, random.uniform(0.1, 1.0));
}
// Down to a thousandth of the ray's length above the triangle's plane.
inline Question grazedTriangleQuestion(Random& random) {
  return triangleAt(random, random.direction(), random.decades(-1, 1), 1.0, random.decades(-3, -1));
}

// Into glass or out of it, through a facet that wo sees; wi is what that facet makes of wo.
inline Question refractionQuestion(Random& random) {
  const glm::dvec3 wo = aboveHorizon(random);
  const double alpha = random.decades(-3, 0), index = random.uniform(1.1, 2.4),
               eta = random.uniform() < 0.5 ? index : 1.0 / index;
  glm::dvec3 h(0.0);
  while (glm::dot(wo, h) <= 0.0 || h.z <= 0.0)
    h = glm::normalize(glm::dvec3(0, 0, 1) +
                       random.direction() * std::min(alpha, 0.7) * random.uniform(0, 2));
  const glm::dvec3 wi = glm::refract(-wo, h, 1.0 / eta);
  const bool passes = glm::length(wi) > 0.5 && wi.z < 0.0;
  return {rowOf(wo, alpha), rowOf(passes ? wi : glm::dvec3(0, 0, -1), eta), rowOf(h)};
}

// A glowing solid of 0.2 to 2 m, up to five times as long as wide, seen from just beside it to 1,000 m.
inline Question solidQuestion(Random& random) {
  const glm::dvec3 x = random.direction(), y = glm::normalize(glm::cross(x, random.direction())),
                   z = glm::cross(x, y), centre = random.direction() * random.decades(-1, 1);
  const glm::dvec3 size(random.uniform(0.2, 1.0), random.uniform(0.2, 1.0), random.uniform(0.2, 1.0));
  const glm::dvec3 p = centre + random.direction() * random.decades(0.2, 3);
  return {rowOf(p, random.uniform(0.0, 0.9999999)), rowOf(glm::dvec3(0), random.uniform(0.0, 0.9999999)),
          rowOf(x / size.x, centre.x), rowOf(y / size.y, centre.y), rowOf(z / size.z, centre.z)};
}

// Numbers near 0 and 1, any bits, directions near the poles, densities from nearly even to a thousand to one.
inline Question warpQuestion(Random& random) {
  const double u = random.uniform() < 0.2 ? random.decades(-7, 0) : random.uniform(0.0, 0.9999999);
  const glm::dvec3 d = random.direction(),
                   polar = glm::normalize(glm::dvec3(0, d.y < 0 ? -1 : 1, 0) + d * random.decades(-4, 0));
  const glm::vec4 first(float(u), float(random.uniform(0.0, 0.9999999)), float(random.decades(-3, 0)),
                        std::bit_cast<float>(std::uint32_t(random.uniform(8388608.0, 2139095039.0))));
  return {first, rowOf(random.uniform() < 0.5 ? polar : d),
          glm::vec4(float(random.decades(-3, 0)), float(random.decades(-3, 0)), float(random.decades(-7, 0)),
                    0.0f)};
}

}  // namespace steradian::kernel
