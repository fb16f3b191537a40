// SPDX-License-Identifier: MIT
// The oracle's black bodies against published chromaticities, and the scene's own colours against them.
#include "tests/oracle/blackbody.hpp"

#include "renderer/scene/light.hpp"
#include "tests/measured.hpp"

namespace steradian::oracle {
namespace {

using glm::dvec2;
using glm::dvec3;

dvec2 chromaticity(const dvec3& xyz) {
  return dvec2(xyz.x, xyz.y) / (xyz.x + xyz.y + xyz.z);
}

TEST(OracleBlackbody, chromaticities_are_those_of_the_tables) {
  // CIE illuminant A (CIE 15:2004; 2,856 K) and the Planckian locus (Wyszecki & Stiles 1982, table 1(3.11))
  const struct {
    double kelvin;
    dvec2 xy;
  } rows[] = {{2000.0, {0.5267, 0.4133}},
              {2855.5, {0.44757, 0.40745}},
              {4000.0, {0.3805, 0.3768}},
              {6500.0, {0.3135, 0.3237}},
              {10000.0, {0.2807, 0.2884}}};
  for (const auto& row : rows) {
    const double off = glm::length(chromaticity(planckXyz(row.kelvin)) - row.xy);
    EXPECT_LE(off, 3e-4) << row.kelvin;
    measured("distance in xy", off, 3e-4);
  }
}

TEST(OracleBlackbody, white_is_white_and_luminance_is_one) {
  const dvec3 white = rec709FromXyz({0.3127 / 0.3290, 1.0, (1.0 - 0.3127 - 0.3290) / 0.3290});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1.0, 1e-12);
  for (const double kelvin : {2000.0, 5000.0, 20000.0})
    EXPECT_NEAR(glm::dot(blackbodyColor(kelvin), dvec3(0.2126, 0.7152, 0.0722)), 1.0, 2e-4);
}

TEST(OracleBlackbody, lights_of_a_temperature_have_its_colour) {
  for (double kelvin = 2000.0; kelvin <= 40000.0; kelvin *= 1.2) {
    const dvec3 expected = blackbodyColor(kelvin);
    const dvec3 color(lightColor({.kind = PointLight{}, .temperature = float(kelvin)}));
    const double off = glm::length(color - expected) / glm::length(expected);
    EXPECT_LE(off, 5e-4) << kelvin;
    measured("relative difference of the colours", off, 5e-4);
  }
}

}  // namespace
}  // namespace steradian::oracle
