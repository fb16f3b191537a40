// SPDX-License-Identifier: MIT
// Samples of lights as kernel_lights.comp answers them.
#pragma once
#include <cstdint>
#include <functional>
#include <numbers>

#include "shaders/kernel_lights.comp.h"
#include "tests/shaders/light_rows.hpp"

namespace steradian::kernel {

inline const Kernel lights{kernel_lights_spirv, "lights"};
inline constexpr Real pi = std::numbers::pi_v<Real>;

/// One answer of the kernel, in double.
struct Sample {
  dvec3 wi;
  double distance, illuminance, pdf, askedPdf, sunRadiance, primitive;
};

class Lights : public KernelTest {
 protected:
  static std::vector<Sample> samplesOf(const Rows& a) {
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < a.size(); i += 3)
      samples.push_back({xyz(a[i]), a[i].w, a[i + 1].x, a[i + 1].w, a[i + 2].x, a[i + 2].y, a[i + 2].z});
    return samples;
  }
  /// Samples of many lights in one dispatch: a question for light i is (p, i) and (u, v, -).
  static std::vector<Sample> ask(const Rows& scene, const Rows& questions) {
    return samplesOf(run(lights, lightTask(0, 2, 3, scene), questions));
  }
  /// Samples of one light from one point.
  static std::vector<Sample> draw(const Rows& light, const vec3& p, std::size_t count) {
    Task task = lightTask(1, 0, 3, light);
    task.invocations = count;
    return samplesOf(run(lights, task, {glm::vec4(p, 0)}));
  }
};

struct Estimate {
  double mean, sigma;
};
inline Estimate estimate(const std::vector<Sample>& samples, const std::function<double(const Sample&)>& f) {
  double sum = 0, squares = 0;
  for (const Sample& s : samples) sum += f(s);
  const double n = double(samples.size()), mean = sum / n;
  for (const Sample& s : samples) squares += std::pow(f(s) - mean, 2);
  return {mean, std::sqrt(squares) / n};
}

/// A unit vector across n.
inline dvec3 across(const dvec3& n, const dvec3& helper) {
  return glm::normalize(glm::cross(n, helper));
}

}  // namespace steradian::kernel
