// SPDX-License-Identifier: MIT
#include "renderer/scene/light.hpp"

#include <algorithm>
#include <cmath>

namespace steradian {
namespace {

// The CIE 1931 2-degree observer from 380 to 780 nm, every 10 nm (CIE 15:2004), to four digits. Fits of it
// are up to 2 % off in the red of warm light.
constexpr double firstWavelength = 380.0, wavelengthStep = 10.0;
constexpr glm::dvec3 observer[] = {
    {0.0014, 0.0000, 0.0065}, {0.0042, 0.0001, 0.0201}, {0.0143, 0.0004, 0.0679}, {0.0435, 0.0012, 0.2074},
    {0.1344, 0.0040, 0.6456}, {0.2839, 0.0116, 1.3856}, {0.3483, 0.0230, 1.7471}, {0.3362, 0.0380, 1.7721},
    {0.2908, 0.0600, 1.6692}, {0.1954, 0.0910, 1.2876}, {0.0956, 0.1390, 0.8130}, {0.0320, 0.2080, 0.4652},
    {0.0049, 0.3230, 0.2720}, {0.0093, 0.5030, 0.1582}, {0.0633, 0.7100, 0.0782}, {0.1655, 0.8620, 0.0422},
    {0.2904, 0.9540, 0.0203}, {0.4334, 0.9950, 0.0087}, {0.5945, 0.9950, 0.0039}, {0.7621, 0.9520, 0.0021},
    {0.9163, 0.8700, 0.0017}, {1.0263, 0.7570, 0.0011}, {1.0622, 0.6310, 0.0008}, {1.0026, 0.5030, 0.0003},
    {0.8544, 0.3810, 0.0002}, {0.6424, 0.2650, 0.0000}, {0.4479, 0.1750, 0.0000}, {0.2835, 0.1070, 0.0000},
    {0.1649, 0.0610, 0.0000}, {0.0874, 0.0320, 0.0000}, {0.0468, 0.0170, 0.0000}, {0.0227, 0.0082, 0.0000},
    {0.0114, 0.0041, 0.0000}, {0.0058, 0.0021, 0.0000}, {0.0029, 0.0010, 0.0000}, {0.0014, 0.0005, 0.0000},
    {0.0007, 0.0002, 0.0000}, {0.0003, 0.0001, 0.0000}, {0.0002, 0.0001, 0.0000}, {0.0001, 0.0000, 0.0000},
    {0.0000, 0.0000, 0.0000}};

// Planck's law but for its constant factor.
double planck(double wavelength, double kelvin) {
  constexpr double c2 = 1.438777e7;  // h c / k, nm K
  return std::pow(wavelength / 560.0, -5.0) / std::expm1(c2 / (wavelength * kelvin));
}

glm::vec3 blackBody(double kelvin) {
  glm::dvec3 xyz(0.0);
  double wavelength = firstWavelength;
  for (const glm::dvec3& seen : observer) {
    xyz += seen * planck(wavelength, kelvin);
    wavelength += wavelengthStep;
  }
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
