// SPDX-License-Identifier: MIT
#include "renderer/scene/metals.hpp"

#include "renderer/scene/fresnel.hpp"

namespace steradian {

namespace {

// Interpolated linearly in wavelength between the neighbouring rows of the tables at refractiveindex.info
// (CC0): Rakic, Djurisic, Elazar & Majewski, Applied Optics 37, 5271 (1998), Brendel-Bormann fit; Johnson &
// Christy, Physical Review B 9, 5056 (1974). The fit smooths several measurements: single ones differ, also
// by several hundredths of reflectance (copper's green is 0.72 here, 0.62 by Johnson & Christy 1972).
constexpr const char* rakic = "Rakic et al. 1998";
constexpr const char* johnson = "Johnson & Christy 1974";
constexpr Metal table[] = {
    {"Aluminium", rakic, {1.3456, 0.96521, 0.61722}, {7.4746, 6.3995, 5.3031}},
    {"Chromium", johnson, {3.1071, 3.1812, 2.3230}, {3.3314, 3.3291, 3.1350}},
    {"Copper", rakic, {0.27105, 0.67693, 1.3164}, {3.6092, 2.6248, 2.2921}},
    {"Gold", rakic, {0.18299, 0.42108, 1.3734}, {3.4242, 2.3459, 1.7704}},
    {"Iron", johnson, {2.9114, 2.9497, 2.5845}, {3.0893, 2.9318, 2.7670}},
    {"Silver", rakic, {0.15943, 0.14512, 0.13547}, {3.9291, 3.1900, 2.3808}},
    {"Titanium", johnson, {2.7407, 2.5418, 2.2670}, {3.8143, 3.4345, 3.0385}},
};

}  // namespace

std::span<const Metal> metals() {
  return table;
}

glm::dvec3 reflectance(const Metal& metal, double cosine) {
  glm::dvec3 r;
  for (int c = 0; c < 3; ++c)
    r[c] = conductorReflectance(metal.n[std::size_t(c)], metal.k[std::size_t(c)], cosine);
  return r;
}

glm::vec3 edgeTintOf(const Metal& metal) {
  constexpr double cosine = 1.0 / 7.0, rest = 1.0 - cosine;
  const glm::dvec3 f0 = reflectance(metal, 1.0);
  const glm::dvec3 schlick = f0 + (1.0 - f0) * (rest * rest * rest * rest * rest);
  return glm::vec3(glm::min(reflectance(metal, cosine) / schlick, 1.0));
}

Material madeOf(const Metal& metal, Material material) {
  material.albedo = glm::vec3(reflectance(metal, 1.0));
  material.edgeTint = edgeTintOf(metal);
  material.metallic = 1.0f;
  return material;
}

}  // namespace steradian
