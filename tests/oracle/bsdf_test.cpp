// SPDX-License-Identifier: MIT
// The oracle's materials against published figures, conservation and reciprocity.
#include "tests/oracle/bsdf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/oracle/random.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian::oracle {
namespace {

constexpr double pi = std::numbers::pi;

Finish finishOf(const Material& m, bool compensate) {
  Finish finish{m};
  if (!compensate) return finish;
  finish.base =
      std::make_shared<AlbedoTable>(double(m.roughness) * m.roughness, m.transmission > 0 ? m.ior : 1.0);
  finish.coat = std::make_shared<AlbedoTable>(double(m.clearcoatRoughness) * m.clearcoatRoughness, 1.0);
  return finish;
}
dvec3 eye(double mu) {
  return {std::sqrt(1.0 - mu * mu), 0.0, mu};
}
/// What comes back to the eye from surroundings of radiance 1 above (and `below` of it beneath).
double albedo(const Bsdf& bsdf, double below = 1.0) {
  double sum = 0.0;
  constexpr int nZ = 800, nPhi = 200;
  for (int i = 0; i < nZ; ++i)
    for (int j = 0; j < nPhi; ++j) {
      const double z = -1.0 + 2.0 * (i + 0.5) / nZ;
      if (z < 0.0 && !bsdf.scattersThrough()) break;
      const double r = std::sqrt(1.0 - z * z), phi = pi * (j + 0.5) / nPhi;
      const dvec3 wi(r * std::cos(phi), r * std::sin(phi), z);
      sum += bsdf.evaluate(wi).x * std::abs(z) * (z < 0.0 ? below : 1.0);
    }
  double deltas = 0.0;
  for (const DeltaLobe& lobe : bsdf.deltas())
    deltas += lobe.energy.x * lobe.compression * (lobe.wi.z < 0.0 ? below : 1.0);
  return sum * 4.0 * pi / (nZ * nPhi) + deltas;
}

TEST(OracleMicrofacet, FresnelHasItsPublishedMeans) {
  const auto mean = [](double n) {
    double sum = 0.0;
    for (int i = 0; i < 100000; ++i) sum += fresnelDielectric(std::sqrt((i + 0.5) / 1e5), 1.0, n) / 1e5;
    return sum;
  };
  EXPECT_NEAR(mean(1.33), 0.065931, 2e-6);
  EXPECT_NEAR(mean(1.5), 0.091778, 2e-6);
  EXPECT_NEAR(mean(2.42), 0.212541, 2e-6);
  EXPECT_EQ(fresnelDielectric(std::sqrt(1.0 - 0.67 * 0.67), 1.5, 1.0), 1.0);  // beyond asin(1 / 1.5)
  EXPECT_LT(fresnelDielectric(std::sqrt(1.0 - 0.66 * 0.66), 1.5, 1.0), 1.0);
}

TEST(OracleMicrofacet, EdgeTintIsTheShareOfSchlickAt82Degrees) {
  const dvec3 f0(0.9, 0.6, 0.3), tint(0.2, 0.5, 1.0);
  const auto schlick = [&](double c) { return f0 + (1.0 - f0) * schlickWeight(c); };
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(fresnelF82(f0, tint, 1.0 / 7.0)[i], tint[i] * schlick(1.0 / 7.0)[i], 1e-12);
    EXPECT_NEAR(fresnelF82(f0, tint, 1.0)[i], f0[i], 1e-12);
    EXPECT_NEAR(fresnelF82(f0, tint, 0.0)[i], 1.0, 1e-12);
  }
}

TEST(OracleMicrofacet, SingleScatterAlbedosAreThePublishedOnes) {
  // Tables: at mu = 1, and cosine-weighted means over mu
  const double rows[][3] = {{0.2, 0.998297, 0},

                            {0.5, 0.915812, 0.8823},
                            {0.7, 0.697750, 0.7074},
                            {1.0, 0.306853, 0.4092}};
  for (const auto& [roughness, front, mean] : rows) {
    const AlbedoTable table(roughness * roughness, 1.0);
    if (front > 0.0) {
      EXPECT_NEAR(table.at(1.0).white, front, 1e-4) << roughness;
    }
    double sum = 0.0;
    for (int i = 0; i < 1000; ++i) sum += table.at(std::sqrt((i + 0.5) / 1000.0)).white / 1000.0;
    if (mean > 0.0) {
      EXPECT_NEAR(sum, mean, 1e-4) << roughness;
    }
  }
}

TEST(OracleBsdf, TheTablesAreTheAlbedosOfTheLobes) {
  for (const float roughness : {0.4f, 0.8f})
    for (const double mu : {0.2, 0.6, 1.0}) {
      Material plastic = scenes::plastic(roughness, glm::vec3(0.0f));
      const AlbedoTable table(double(roughness) * roughness, 1.5);
      const auto row = table.at(mu);
      const Finish single = finishOf(plastic, false);
      EXPECT_NEAR(albedo(Bsdf(single, eye(mu), true, true)), 0.04 * (row.white - row.grazing) + row.grazing,
                  1e-4);
      plastic.transmission = 1.0f;
      const Finish glass = finishOf(plastic, false);
      EXPECT_NEAR(albedo(Bsdf(glass, eye(mu), true, true), 0.0), row.exactOutside, 1e-4);
      EXPECT_NEAR(albedo(Bsdf(glass, eye(mu), false, true), 0.0), row.exactInside, 2e-3);
    }
}

TEST(OracleBsdf, CompensatedSurfacesLoseNothing) {
  for (const float roughness : {0.0f, 0.4f, 1.0f})
    for (const float metallic : {0.0f, 0.5f, 1.0f}) {
      Material m = scenes::plastic(roughness, glm::vec3(1.0f));
      m.metallic = metallic;
      m.clearcoat = 0.7f;
      m.clearcoatRoughness = 0.3f;
      const Finish finish = finishOf(m, true);
      for (const double mu : {0.15, 0.6})
        EXPECT_NEAR(albedo(Bsdf(finish, eye(mu), true, true)), 1.0, 2e-3) << roughness << metallic << mu;
    }
}

TEST(OracleBsdf, CompensatedGlassLosesNothingBetweenEqualRadiancesPerSquaredIndex) {
  Material m = scenes::plastic(0.0f, glm::vec3(1.0f));
  m.transmission = 1.0f;
  for (const float roughness : {0.5f, 1.0f}) {
    m.roughness = roughness;
    const Finish finish = finishOf(m, true);
    const double n2 = double(m.ior) * m.ior;
    for (const double mu : {0.3, 0.8}) {
      EXPECT_NEAR(albedo(Bsdf(finish, eye(mu), true, true), n2), 1.0, 3e-3) << roughness << " outside " << mu;
      EXPECT_NEAR(albedo(Bsdf(finish, eye(mu), false, true), 1.0 / n2), 1.0, 3e-3)
          << roughness << " inside " << mu;
      EXPECT_NEAR(albedo(Bsdf(finish, eye(mu), true, false)), 1.0, 3e-3) << roughness << " a pane " << mu;
    }
  }
}

TEST(OracleBsdf, SingleScatterIsReciprocalUnlessLayered) {
  std::seed_seq seed{11};
  Random random(seed);
  Material m = scenes::plastic(0.5f, {0.3f, 0.5f, 0.9f});
  m.metallic = 0.4f;
  m.edgeTint = glm::vec3(0.6f);
  const Finish finish = finishOf(m, false);
  for (int i = 0; i < 1000; ++i) {
    dvec3 a = random.onSphere(), b = random.onSphere();
    a.z = std::abs(a.z), b.z = std::abs(b.z);
    const dvec3 ab = Bsdf(finish, a, true, true).evaluate(b), ba = Bsdf(finish, b, true, true).evaluate(a);
    EXPECT_NEAR(ab.y, ba.y, 1e-12 * ab.y);
  }
}

TEST(OracleBsdf, RoughGlassObeysTheReciprocityOfRefraction) {
  // f(o, i) / eta_o^2 = f(i, o) / eta_i^2 (Walter et al. 2007; Veach 1997, eq. 5.14)
  std::seed_seq seed{12};
  Random random(seed);
  Material m = scenes::plastic(0.6f, glm::vec3(1.0f));
  m.transmission = 1.0f;
  const Finish finish = finishOf(m, false);
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    dvec3 o = random.onSphere(), t = random.onSphere();
    o.z = std::abs(o.z), t.z = -std::abs(t.z);
    const double in = Bsdf(finish, o, true, true).evaluate(t).x;
    const double out = Bsdf(finish, dvec3(t.x, t.y, -t.z), false, true).evaluate(dvec3(o.x, o.y, -o.z)).x;
    EXPECT_NEAR(in, out / (1.5 * 1.5), 1e-12 * in + 1e-15);
    compared += in > 0.0;
  }
  EXPECT_GT(compared, 200);
}

TEST(OracleBsdf, GlassBetweenEqualRadiancesPerSquaredIndexShinesAsThem) {
  // Radiance / index^2 is what a clear boundary keeps: inside it is 1.5^2 times the outside's.
  for (const float roughness : {0.0f, 0.25f})
    for (const double mu : {0.8, 0.95}) {
      Material m = scenes::plastic(roughness, glm::vec3(1.0f));
      m.transmission = 1.0f;
      const Finish finish = finishOf(m, false);
      const double gate = roughness > 0.0f ? 0.01 : 1e-12;  // single scatter loses a little
      EXPECT_NEAR(albedo(Bsdf(finish, eye(mu), true, true), 2.25), 1.0, gate);
      EXPECT_NEAR(albedo(Bsdf(finish, eye(mu), false, true), 1.0 / 2.25), 1.0, gate);
    }
}

}  // namespace
}  // namespace steradian::oracle
