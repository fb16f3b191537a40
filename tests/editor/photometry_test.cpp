// SPDX-License-Identifier: MIT
// Lumen and candela of every kind of light against what the integrals give by hand.
#include "editor/photometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steradian {
namespace {

constexpr double kPi = 3.14159265358979323846;

glm::dmat4 scaled(double x, double y, double z) {
  glm::dmat4 m(1.0);
  m[0] *= x, m[1] *= y, m[2] *= z;
  return m;
}

TEST(Photometry, point_and_spot_lights_keep_their_candela_and_fill_their_solid_angle) {
  EXPECT_NEAR(*luminousFlux({PointLight{}, glm::vec3(1), 10}, scaled(2, 3, 4)), 40.0 * kPi, 1e-4);
  EXPECT_NEAR(*intensityAhead({SpotLight{}, glm::vec3(1), 10}, glm::dmat4(1)), 10.0, 1e-5);
  // A hemisphere of full intensity
  const Light half{SpotLight{1.5707f, 1.5707963f}, glm::vec3(1), 1};
  EXPECT_NEAR(*luminousFlux(half, glm::dmat4(1)), 2.0 * kPi, 1e-3);
}

TEST(Photometry, a_lamberts_flux_is_pi_times_its_intensity_ahead) {
  const Light panel{RectLight{{2, 3}}, glm::vec3(1), 100};
  EXPECT_NEAR(*intensityAhead(panel, scaled(0.5, 2, 7)), 600.0, 1e-3);
  EXPECT_NEAR(*luminousFlux(panel, scaled(0.5, 2, 7)), 600.0 * kPi, 1e-2);
  const Light disk{DiskLight{2}, glm::vec3(1), 100};
  EXPECT_NEAR(*intensityAhead(disk, glm::dmat4(1)), 400.0 * kPi, 1e-2);
}

TEST(Photometry, a_sphere_shines_all_around_unless_it_is_scaled_unevenly) {
  const Light globe{SphereLight{0.5}, glm::vec3(1), 100};
  EXPECT_NEAR(*intensityAhead(globe, scaled(2, 2, 2)), 100.0 * kPi, 1e-3);
  EXPECT_NEAR(*luminousFlux(globe, scaled(2, 2, 2)), 400.0 * kPi * kPi, 1e-2);
  EXPECT_FALSE(luminousFlux(globe, scaled(2, 1, 1)));
}

TEST(Photometry, colour_counts_by_its_luminance_and_temperature_not_at_all) {
  const Light green{PointLight{}, {0, 1, 0}, 1};
  EXPECT_NEAR(*intensityAhead(green, glm::dmat4(1)), 0.7152, 1e-6);
  for (const float kelvin : {1000.0f, 2700.0f, 6500.0f, 40000.0f})
    EXPECT_NEAR(*intensityAhead({.kind = PointLight{}, .intensity = 1, .temperature = kelvin}, glm::dmat4(1)),
                1.0, 1e-5)
        << kelvin;
}

TEST(Photometry, what_has_no_flux_says_so) {
  EXPECT_FALSE(luminousFlux(Light{DirectionalLight{}}, glm::dmat4(1)));
  EXPECT_FALSE(luminousFlux(Light{EnvironmentLight{}}, glm::dmat4(1)));
}

}  // namespace
}  // namespace steradian
