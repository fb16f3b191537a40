// SPDX-License-Identifier: MIT
#include "renderer/scene/light.hpp"

#include <algorithm>
#include <cmath>

namespace steradian {
namespace {

// One lobe of the fits below: a Gaussian with a width for each side. Wavelengths in nanometres.
double lobe(double wavelength, double centre, double below, double above) {
  const double x = (wavelength - centre) / (wavelength < centre ? below : above);
  return std::exp(-0.5 * x * x);
}

// CIE 1931 colour matching functions (Wyman, Sloan & Shirley, JCGT 2(2), 2013, multi-lobe fits).
glm::dvec3 matchingFunctions(double w) {
  return {1.056 * lobe(w, 599.8, 37.9, 31.0) + 0.362 * lobe(w, 442.0, 16.0, 26.7) -
              0.065 * lobe(w, 501.1, 20.4, 26.2),
          0.821 * lobe(w, 568.8, 46.9, 40.5) + 0.286 * lobe(w, 530.9, 16.3, 31.1),
          1.217 * lobe(w, 437.0, 11.8, 36.0) + 0.681 * lobe(w, 459.0, 26.0, 13.8)};
}

// Planck's law but for its constant factor.
double planck(double wavelength, double kelvin) {
  constexpr double c2 = 1.438777e7;  // h c / k, nm K
  return std::pow(wavelength / 560.0, -5.0) / std::expm1(c2 / (wavelength * kelvin));
}

glm::vec3 blackBody(double kelvin) {
  glm::dvec3 xyz(0.0);
  for (double w = 360.0; w <= 830.0; w += 5.0) xyz += matchingFunctions(w) * planck(w, kelvin);
  xyz /= xyz.y;
  // Rec. 709 primaries, D65 (IEC 61966-2-1)
  const glm::dvec3 rgb(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
                       -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
                       0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z);
  const glm::dvec3 inGamut = glm::max(rgb, glm::dvec3(0.0));  // deep reds lie outside
  return glm::vec3(inGamut / glm::dot(inGamut, glm::dvec3(0.2126, 0.7152, 0.0722)));
}

}  // namespace

glm::vec3 lightColor(const Light& light) {
  if (light.temperature <= 0.0f) return light.color;
  return light.color * blackBody(std::clamp(double(light.temperature), 1000.0, 40000.0));
}

}  // namespace steradian
