// SPDX-License-Identifier: MIT
// Numbers and directions drawn evenly.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/glm.hpp>

namespace steradian::oracle {

class Random {
 public:
  explicit Random(std::seed_seq& seed) : engine_(seed) {}

  /// In [0, 1).
  double uniform() { return double(engine_() >> 11) * 0x1p-53; }
  /// Even over the unit sphere (Archimedes: heights are even).
  glm::dvec3 onSphere() {
    const double z = 2.0 * uniform() - 1.0, phi = 2.0 * std::numbers::pi * uniform();
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  /// Even over the unit disc, by rejection.
  glm::dvec2 inDisc() {
    for (;;) {
      const glm::dvec2 p(2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0);
      if (glm::dot(p, p) < 1.0) return p;
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace steradian::oracle
