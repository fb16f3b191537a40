// SPDX-License-Identifier: MIT
// Metals: the curve that materials keep, against Fresnel's equations for their optical constants.
#include "renderer/scene/metals.hpp"

#include <gtest/gtest.h>

#include <array>
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

/// The published rows (micrometres, n, k) around 0.65, 0.55 and 0.45 micrometres.
struct Row {
  double wavelength, n, k;
};
struct Published {
  const char* name;
  std::array<std::array<Row, 2>, 3> around;
};
const Published published[] = {
    {"Aluminium",
     {{{{{.63971, 1.2952, 7.3576}, {.66693, 1.4286, 7.6672}}},
       {{{.54147, .93525, 6.3099}, {.56452, 1.0162, 6.5519}}},
       {{{.43962, .58336, 5.1830}, {.45833, .64439, 5.3994}}}}}},
    {"Chromium",
     {{{{{.617, 3.17, 3.30}, {.659, 3.09, 3.34}}},
       {{{.549, 3.18, 3.33}, {.582, 3.22, 3.30}}},
       {{{.431, 2.19, 3.04}, {.451, 2.33, 3.14}}}}}},
    {"Copper",
     {{{{{.64071, .28853, 3.5153}, {.65403, .26347, 3.6500}}},
       {{{.54348, .72204, 2.5713}, {.55477, .64392, 2.6639}}},
       {{{.44241, 1.3316, 2.2956}, {.45161, 1.3132, 2.2913}}}}}},
    {"Gold",
     {{{{{.64396, .18664, 3.3662}, {.65446, .18030, 3.4671}}},
       {{{.54779, .43326, 2.3201}, {.55672, .38405, 2.4245}}},
       {{{.44390, 1.4126, 1.7829}, {.45114, 1.3661, 1.7681}}}}}},
    {"Iron",
     {{{{{.617, 2.88, 3.05}, {.659, 2.92, 3.10}}},
       {{{.549, 2.95, 2.93}, {.582, 2.94, 2.99}}},
       {{{.431, 2.48, 2.71}, {.451, 2.59, 2.77}}}}}},
    {"Silver",
     {{{{{.64973, .15939, 3.9272}, {.66263, .16143, 4.0200}}},
       {{{.54437, .14440, 3.1471}, {.55518, .14578, 3.2295}}},
       {{{.44722, .13537, 2.3564}, {.45610, .13569, 2.4344}}}}}},
    {"Titanium",
     {{{{{.617, 2.67, 3.72}, {.659, 2.76, 3.84}}},
       {{{.549, 2.54, 3.43}, {.582, 2.60, 3.58}}},
       {{{.431, 2.21, 3.01}, {.451, 2.27, 3.04}}}}}},
};

TEST(Metals, TheirOpticalConstantsArePublished) {
  constexpr double wavelengths[] = {.65, .55, .45};
  ASSERT_EQ(metals().size(), std::size(published));
  for (std::size_t m = 0; m < metals().size(); ++m) {
    ASSERT_STREQ(metals()[m].name, published[m].name);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& [a, b] = published[m].around[c];
      const double t = (wavelengths[c] - a.wavelength) / (b.wavelength - a.wavelength);
      EXPECT_NEAR(metals()[m].n[c], std::lerp(a.n, b.n, t), 2e-4) << metals()[m].name;
      EXPECT_NEAR(metals()[m].k[c], std::lerp(a.k, b.k, t), 2e-4) << metals()[m].name;
    }
  }
}

TEST(Metals, HeadOnTheyReflectWhatFollows) {
  const std::map<std::string, glm::dvec3> rounded = {{"Aluminium", {.912, .914, .920}},
                                                     {"Copper", {.926, .721, .504}},
                                                     {"Gold", {.944, .776, .373}},
                                                     {"Silver", {.962, .949, .922}},
                                                     {"Titanium", {.616, .582, .544}}};
  for (const Metal& metal : metals()) {
    const auto known = rounded.find(metal.name);
    if (known == rounded.end()) continue;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(reflectance(metal, 1.0)[c], known->second[c], 0.001) << metal.name;
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

TEST(Fresnel, the_mean_of_what_passes_a_smooth_surface_is_its_integral) {
  for (const double ior : {1.0, 1.000001, 1.1, 1.5, 2.42, 30.0}) {
    constexpr int points = 200'000;
    double sum = 0.0;
    for (int i = 0; i < points; ++i)  // 2 cos d(cos) = d(cos^2)
      sum += 1.0 - byAmplitudes(ior, 0.0, std::sqrt((i + 0.5) / points));
    EXPECT_NEAR(meanTransmittance(ior), sum / points, 1e-6) << ior;
  }
}

}  // namespace
}  // namespace steradian
