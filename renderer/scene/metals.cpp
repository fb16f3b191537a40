// SPDX-License-Identifier: MIT
#include "renderer/scene/metals.hpp"

#include "renderer/scene/fresnel.hpp"

namespace steradian {

namespace {

constexpr Metal table[] = {
    {"Aluminium", "Rakic 1995", {1.3456, 0.96521, 0.61722}, {7.4746, 6.3995, 5.3031}},
    {"Chromium", "Johnson & Christy 1974", {3.1071, 3.1812, 2.3230}, {3.3314, 3.3291, 3.1350}},
    {"Copper", "Johnson & Christy 1972", {0.27105, 0.67693, 1.3164}, {3.6092, 2.6248, 2.2921}},
    {"Gold", "Johnson & Christy 1972", {0.18299, 0.42108, 1.3734}, {3.4242, 2.3459, 1.7704}},
    {"Iron", "Johnson & Christy 1974", {2.9114, 2.9497, 2.5845}, {3.0893, 2.9318, 2.7670}},
    {"Silver", "Johnson & Christy 1972", {0.15943, 0.14512, 0.13547}, {3.9291, 3.1900, 2.3808}},
    {"Titanium", "Johnson & Christy 1974", {2.74, 2.54, 2.27}, {3.82, 3.43, 3.04}},
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
