// SPDX-License-Identifier: MIT
// Histograms of light samples: each fills what it should, as evenly as it states.
#include "tests/shaders/histogram.hpp"
#include "tests/shaders/light_samples.hpp"

namespace steradian::kernel {
namespace {

/// Azimuth around an axis, in turns.
double turn(double x, double y) {
  const double angle = std::atan2(y, x) / (2 * M_PI);
  return angle < 0 ? angle + 1 : angle;
}

/// Evenness over the cone of 1 - cos <= x around the axis.
double coneP(const std::vector<Sample>& samples, const dvec3& axis, double x) {
  const dvec3 t = across(axis, dvec3(0.3, 0.5, -0.7)), b = glm::cross(axis, t);
  return histogramP(
      samples,
      [&](const Sample& s) {
        const dvec3 chord = s.wi - axis;
        return dvec3(0.5 * glm::dot(chord, chord) / x, turn(glm::dot(s.wi, t), glm::dot(s.wi, b)), 0);
      },
      evenShare);
}

TEST_F(Lights, row24_cones_of_spheres_and_suns_are_filled_evenly) {
  const vec3 p(0.1f, 0.2f, 0.3f);
  for (const double ratio : {1.05, 2.0, 50.0}) {
    const vec3 centre = p + vec3(dvec3(2, -3, 6) / 7.0 * ratio);
    const dvec3 f = dvec3(centre) - dvec3(p);
    const double s2 = 1 / glm::dot(f, f);
    const auto samples = draw(sphereLight(centre, 1, 1), p, manySamples);
    expectEven(coneP(samples, glm::normalize(f), s2 / (1 + std::sqrt(1 - s2))), sidak, std::to_string(ratio));
  }
  expectEven(coneP(draw(sphereLight(p + vec3(0.5f, 0, 0), 1, 1), p, manySamples), {1, 0, 0}, 2), sidak,
             "inside");
  for (const double half : {0.00465, 0.7}) {
    const vec3 axis(glm::normalize(dvec3(-1, 2, 0.5)));
    const double s = std::sin(0.5 * half);
    expectEven(
        coneP(draw(directionalLight(axis, 1, half), p, manySamples), glm::normalize(dvec3(axis)), 2 * s * s),
        sidak, std::to_string(half));
  }
}

TEST_F(Lights, row24_rects_are_filled_evenly_by_solid_angle) {
  const vec3 p(0.1f, 0.2f, 0.3f), u(0.9f, 0, 0), v(0, 0.5f, 0);
  // Head on, oblique with corners far off, close, and hardly above the smallest solid angle.
  for (const vec3& offset :
       {vec3(0, 0, -1), vec3(2, 1, -0.5f), vec3(0.3f, 0.1f, -0.05f), vec3(60, 20, -80)}) {
    const Rows light = flatLight(gpu::LIGHT_RECT, p + offset, 1, u, v);
    const SeenRect seen(light, Vec(p));
    const auto samples = draw(light, p, manySamples);
    const Real whole = seen.solidAngle(), dx = (seen.x1 - seen.x0) / 101, dy = (seen.y1 - seen.y0) / 202;
    const double probability = histogramP(
        samples,
        [&](const Sample& s) {
          const Vec at = Vec(s.wi) * Real(s.distance);
          return dvec3((glm::dot(at, seen.ex) - seen.x0) / (seen.x1 - seen.x0),
                       (glm::dot(at, seen.ey) - seen.y0) / (seen.y1 - seen.y0), 0);
        },
        [&](int r, int c) {
          const Real x = seen.x0 + Real(r) * dx, y = seen.y0 + Real(c) * dy;
          return double(seen.solidAngle(x, x + dx, y, y + dy) / whole);
        });
    expectEven(probability, sidak, "offset " + std::to_string(offset.x));
  }
}

}  // namespace
}  // namespace steradian::kernel
