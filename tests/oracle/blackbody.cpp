// SPDX-License-Identifier: MIT
#include "tests/oracle/blackbody.hpp"

#include <cmath>

namespace steradian::oracle {
namespace {

using glm::dmat3;
using glm::dvec3;

// The 2-degree observer of 1931 from 380 to 780 nm, every 10 nm (CIE 15:2004), to four digits.
constexpr double kFirst = 380.0, kStep = 10.0;
constexpr double kObserver[][3] = {
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

dvec3 xyzOf(double x, double y) {
  return {x / y, 1.0, (1.0 - x - y) / y};
}

}  // namespace

dvec3 planckXyz(double kelvin) {
  constexpr double secondRadiationConstant = 1.438776877e7;  // nm K (CODATA 2018)
  dvec3 sum(0.0);
  double nanometres = kFirst;
  for (const auto& [x, y, z] : kObserver) {
    const double exponent = secondRadiationConstant / (nanometres * kelvin);
    sum += dvec3(x, y, z) / (std::pow(nanometres, 5.0) * std::expm1(exponent));
    nanometres += kStep;
  }
  return sum / sum.y;
}

dvec3 rec709FromXyz(const dvec3& xyz) {
  const dmat3 primaries(xyzOf(0.64, 0.33), xyzOf(0.30, 0.60), xyzOf(0.15, 0.06));
  const dvec3 amounts = glm::inverse(primaries) * xyzOf(0.3127, 0.3290);  // that make white
  return (glm::inverse(primaries) * xyz) / amounts;
}

dvec3 blackbodyColor(double kelvin) {
  return rec709FromXyz(planckXyz(kelvin));
}

}  // namespace steradian::oracle
