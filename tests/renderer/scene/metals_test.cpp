// SPDX-License-Identifier: MIT
// Metals: the curve that materials keep, against Fresnel's equations for their optical constants.
#include "renderer/scene/metals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <string>

#include "renderer/scene/fresnel.hpp"

namespace steradian {
namespace {

/// By complex amplitudes, another way than the product's.
double byAmplitudes(double n, double k, double cosine) {
  const std::complex<double> m(n, k), sine2(1.0 - cosine * cosine, 0.0);
  const std::complex<double> cosT = std::sqrt(1.0 - sine2 / (m * m));
  const auto s = (cosine - m * cosT) / (cosine + m * cosT), p = (m * cosine - cosT) / (m * cosine + cosT);
  return 0.5 * (std::norm(s) + std::norm(p));
}

double schlick(double f0, double cosine) {
  return f0 + (1.0 - f0) * std::pow(1.0 - cosine, 5);
}

struct Worst {
  double schlick = 0.0, fit = 0.0;
};
Worst worstOf(const Metal& metal) {
  const Material m = madeOf(metal, {});
  const glm::dvec3 a(f82Coefficient(m.albedo, m.edgeTint));
  Worst worst;
  for (int i = 0; i <= 200; ++i)
    for (int c = 0; c < 3; ++c) {
      const double cosine = i / 200.0, exact = reflectance(metal, cosine)[c];
      const double plain = schlick(m.albedo[c], cosine);
      const double fit = plain - a[c] * cosine * std::pow(1.0 - cosine, 6);
      worst.schlick = std::max(worst.schlick, std::abs(plain - exact));
      worst.fit = std::max(worst.fit, std::abs(fit - exact));
    }
  return worst;
}

TEST(Metals, ReflectanceAgreesWithComplexAmplitudes) {
  for (const Metal& metal : metals())
    for (const double cosine : {0.01, 0.1, 0.5, 0.9, 1.0})
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(reflectance(metal, cosine)[int(c)], byAmplitudes(metal.n[c], metal.k[c], cosine), 1e-12);
}

TEST(Metals, HeadOnTheyReflectWhatIsPublished) {
  // Linear Rec. 709 of the table at physicallybased.info.
  const std::map<std::string, glm::vec3> published = {{"Aluminium", {.912f, .914f, .920f}},
                                                      {"Copper", {.926f, .721f, .504f}},
                                                      {"Gold", {.944f, .776f, .373f}},
                                                      {"Silver", {.962f, .949f, .922f}},
                                                      {"Titanium", {.616f, .582f, .544f}}};
  for (const Metal& metal : metals()) {
    const auto known = published.find(metal.name);
    if (known == published.end()) continue;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(reflectance(metal, 1.0)[c], known->second[c], 0.002) << metal.name;
  }
}

TEST(Metals, TheEdgeTintHalvesSchlicksErrorWhereItIsLarge) {
  for (const Metal& metal : metals()) {
    const Worst worst = worstOf(metal);
    EXPECT_LE(worst.schlick, 0.21) << metal.name;
    EXPECT_LE(worst.fit, 0.025) << metal.name;
    if (worst.schlick > 0.08) {
      EXPECT_LT(worst.fit, 0.5 * worst.schlick) << metal.name;
    }
    RecordProperty(std::string(metal.name) + "_schlick", std::to_string(worst.schlick));
    RecordProperty(std::string(metal.name) + "_fit", std::to_string(worst.fit));
  }
}

TEST(Metals, OnlyTheSurfaceOfAMaterialChanges) {
  Material coated;
  coated.name = "bolt";
  coated.roughness = 0.3f;
  coated.clearcoat = 0.5f;
  const Material made = madeOf(metals()[0], coated);
  EXPECT_EQ(made.name, "bolt");
  EXPECT_EQ(made.roughness, 0.3f);
  EXPECT_EQ(made.clearcoat, 0.5f);
  EXPECT_EQ(made.metallic, 1.0f);
}

}  // namespace
}  // namespace steradian
