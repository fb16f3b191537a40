// SPDX-License-Identifier: MIT
#include "renderer/scene/fresnel.hpp"

#include <cmath>

namespace steradian {

double conductorReflectance(double n, double k, double cosine) {
  const double cos2 = cosine * cosine, sin2 = 1.0 - cos2, n2 = n * n, k2 = k * k;
  const double t0 = n2 - k2 - sin2;
  const double a2b2 = std::sqrt(t0 * t0 + 4.0 * n2 * k2);  // a + ib = sqrt((n + ik)^2 - sin^2)
  const double a = std::sqrt(std::fmax(0.0, 0.5 * (a2b2 + t0)));
  const double s = (a2b2 + cos2 - 2.0 * a * cosine) / (a2b2 + cos2 + 2.0 * a * cosine);
  const double p = s * (cos2 * a2b2 + sin2 * sin2 - 2.0 * a * cosine * sin2) /
                   (cos2 * a2b2 + sin2 * sin2 + 2.0 * a * cosine * sin2);
  return 0.5 * (s + p);
}

glm::vec3 f82Coefficient(const glm::vec3& f0, const glm::vec3& edgeTint) {
  constexpr float cosine = 1.0f / 7.0f, rest = 1.0f - cosine;
  constexpr float rest5 = rest * rest * rest * rest * rest;
  const glm::vec3 schlick = f0 + (glm::vec3(1.0f) - f0) * rest5;
  return schlick * (glm::vec3(1.0f) - edgeTint) / (cosine * rest * rest5);
}

double meanTransmittance(double ior) {
  const double above = ior - 1.0, n2 = ior * ior, sum = n2 + 1.0, difference = above * (ior + 1.0);
  if (above <= 0.0) return 1.0;
  const double quartic = sum * difference;  // n^4 - 1, with all digits near n = 1
  return 0.5 - above * (3.0 * ior + 1.0) / (6.0 * (ior + 1.0) * (ior + 1.0)) -
         n2 * difference * difference / (sum * sum * sum) * std::log(above / (ior + 1.0)) +
         2.0 * n2 * ior * (n2 + 2.0 * ior - 1.0) / (sum * quartic) -
         8.0 * n2 * n2 * (n2 * n2 + 1.0) / (sum * quartic * quartic) * std::log1p(above);
}

}  // namespace steradian
