// SPDX-License-Identifier: MIT
// Sampling agrees with evaluation: histograms, weights, densities that integrate to one, combination of
// strategies.
#include <cmath>
#include <cstdint>
#include <functional>

#include "shaders/kernel_sampling.comp.h"
#include "tests/shaders/bsdf_rows.hpp"
#include "tests/shaders/chi_square.hpp"

namespace steradian::kernel {
namespace {

const Kernel sampling{kernel_sampling_spirv, "sampling"};
constexpr std::size_t samples = 1000000;

class Lobes : public KernelTest {};

const double significance = 1 - std::pow(0.99, 1.0 / 14);  // Sidak: fourteen histograms

TEST_F(Lobes, row24_cosine_hemisphere_has_its_density) {
  const Rows drawn = run(sampling, {.operation = 1, .rowsIn = 0, .invocations = samples}, {});
  expectDensity(chiSquare(drawn, 1, [](oracle::Vec w) { return w.z / M_PI; }), significance, "cosine");
  EXPECT_LT(chiSquare(drawn, 1, [](oracle::Vec) { return 0.5 / M_PI; }), significance)
      << "the test must bite";
}

TEST_F(Lobes, row24_visible_normals_have_their_density) {
  const double table[][2] = {{0.9, 0.1}, {0.3, 0.5}, {0.05, 1.0}, {1.0, 0.25}};
  for (const auto& [mu, alpha] : table) {
    const glm::vec4 question(glm::vec3(direction(mu, 0.7)), alpha);
    const Rows drawn = run(sampling, {.operation = 2, .rowsIn = 0, .invocations = samples}, {question});
    const oracle::Vec wo(xyz(question));
    const oracle::Real a = question.w;
    expectDensity(chiSquare(drawn, 1, [&](oracle::Vec m) { return oracle::visiblePdf(wo, m, a); }),
                  significance, "alpha " + std::to_string(alpha));
  }
}

struct Mixture {
  const char* name;
  Material material;
  double mu;
  float chance;
};

Material coated(Material base, float alpha, float chance) {
  base.lobes += coatBit;
  base.coat = 0.9f;
  base.coatAlpha = alpha;
  base.coatChance = chance;
  return base;
}

// Total reflection begins where one ring of the histogram ends.
const float milkEta = std::sqrt(1.0f - 75.0f / 101 * (75.0f / 101));
/// Diffuse light behind smooth glass, seen from outside or from within.
Material milk(float eta, float meanPassed) {
  Material m = lobes(gltf({0.9f, 0.8f, 0.7f}, 0.0f, 0.0f, 0.0f), diffuseBit + transmissionBit);
  m.dielectricF90 = 0.0f;
  m.eta = eta;
  m.diffusePassed = 1.0f / meanPassed;
  return m;
}

const Mixture mixtures[] = {
    {"glossy plastic", gltf({0.8f, 0.4f, 0.2f}, 0.0f, 0.3f), 0.6, 0.4f},
    {"rough plastic, grazing", gltf({0.5f, 0.5f, 0.5f}, 0.0f, 0.8f), 0.15, 0.3f},
    {"metal", lobes(gltf({1.0f, 0.8f, 0.3f}, 1.0f, 0.15f), glossyBit), 0.5, 1.0f},
    {"roughest metal", lobes(gltf({1.0f, 1.0f, 1.0f}, 1.0f, 1.0f), glossyBit), 0.999, 1.0f},
    {"chalk", lobes(gltf({0.9f, 0.9f, 0.9f}, 0.0f, 1.0f, 0.0f), diffuseBit), 0.4, 0.0f},
    {"coated plastic", coated(gltf({0.8f, 0.4f, 0.2f}, 0.0f, 0.5f), 0.15f, 0.35f), 0.6, 0.25f},
    {"rough coat alone, grazing", coated(lobes({}, 0), 0.4f, 1.0f), 0.2, 0.0f},
    {"milk", milk(1 / milkEta, 0.9f), 0.5, 0.0f},
    {"milk from within", milk(milkEta, 0.9f), 0.9, 0.0f}};

/// The sine squared within which the diffuse lobe sends light.
oracle::Real diffuseRange(const Material& m) {
  return m.diffusePassed > 0 ? std::min<oracle::Real>(oracle::Real(m.eta) * m.eta, 1) : 1;
}

/// Of what Lambert sends along wi.
oracle::Real diffuseShape(const Material& m, oracle::Vec wi) {
  if (m.diffusePassed <= 0) return 1;
  return (1 - oracle::fresnel(wi.z, m.eta)) * m.diffusePassed / diffuseRange(m);
}

oracle::Real mixturePdf(const Mixture& mix, oracle::Vec wo, oracle::Vec wi) {
  const Material& m = mix.material;
  const bool sent = 1 - wi.z * wi.z <= diffuseRange(m);
  const oracle::Real lambert = sent ? wi.z / (M_PIl * diffuseRange(m)) : 0;
  oracle::Real pdf = (1 - oracle::Real(mix.chance) - m.coatChance) * lambert;
  if (mix.chance > 0) pdf += mix.chance * oracle::reflectedPdf(wo, wi, m.alpha);
  if (m.coatChance > 0) pdf += m.coatChance * oracle::reflectedPdf(wo, wi, m.coatAlpha);
  return pdf;
}

/// f cos of one channel, from the glTF formulas; the coat's base is not yet dimmed here.
oracle::Real mixtureValue(const Material& m, oracle::Vec wo, oracle::Vec wi, int channel) {
  const oracle::Vec h = glm::normalize(wo + wi);
  const oracle::Real cosine = glm::dot(wo, h), a = m.alpha;
  oracle::Real f = 0;
  if (int(m.lobes) & 1)
    f += m.diffuse[channel] * (1 - oracle::schlick(m.dielectricF0, m.dielectricF90, cosine)) *
         diffuseShape(m, wi) * wi.z / M_PIl;
  if (int(m.lobes) & 2)
    f += oracle::schlick(m.f0[channel], m.f90.x, cosine) * oracle::ggxD(h, a) * oracle::g2(wo, wi, a) /
         (4 * wo.z);
  if (int(m.lobes) & 16)
    f += m.coat * oracle::schlick(0.04L, 1, cosine) * oracle::ggxD(h, m.coatAlpha) *
         oracle::g2(wo, wi, m.coatAlpha) / (4 * wo.z);
  return f;
}

Rows drawMixture(const Mixture& mix,
                 const std::function<Rows(const Kernel&, const Task&, const Rows&)>& run) {
  Rows question;
  pushBsdf(question, mix.material, glm::vec3(direction(mix.mu, 0.7)), {}, mix.chance);
  return run(bsdf, {.operation = 2, .rowsIn = 0, .rowsOut = 3, .invocations = samples}, question);
}

TEST_F(Lobes, row24_mixtures_are_sampled_with_the_density_they_state) {
  for (const Mixture& mix : mixtures) {
    const Rows drawn =
        drawMixture(mix, [](const Kernel& k, const Task& t, const Rows& r) { return run(k, t, r); });
    const oracle::Vec wo{glm::dvec3(glm::vec3(direction(mix.mu, 0.7)))};
    expectDensity(chiSquare(drawn, 3, [&](oracle::Vec wi) { return mixturePdf(mix, wo, wi); }), significance,
                  mix.name);
  }
}

TEST_F(Lobes, row25_weights_and_densities_agree_with_long_double) {
  for (const Mixture& mix : mixtures) {
    const Rows drawn =
        drawMixture(mix, [](const Kernel& k, const Task& t, const Rows& r) { return run(k, t, r); });
    const oracle::Vec wo{glm::dvec3(glm::vec3(direction(mix.mu, 0.7)))};
    double worstPdf = 0, worstWeight = 0, below = 0;
    for (std::size_t i = 0; i < drawn.size(); i += 3) {
      const oracle::Vec wi(xyz(drawn[i]));
      if (wi.z <= 0) {
        below += 1;
        ASSERT_EQ(drawn[i + 1].x + drawn[i + 1].y + drawn[i + 1].z + drawn[i + 2].w, 0.0f) << mix.name;
        continue;
      }
      if (i % 90 != 0 || wi.z < 1e-4L || 1 - wi.z * wi.z > 0.999L * diffuseRange(mix.material))
        continue;  // long double is slow, and there the float cosine itself has fewer digits than the gate
      const oracle::Real pdf = mixturePdf(mix, wo, wi);
      worstPdf = std::max(worstPdf, std::fabs(double(drawn[i + 2].w / pdf - 1)));
      for (int c = 0; c < 3; ++c)
        worstWeight =
            std::max(worstWeight,
                     std::fabs(double(drawn[i + 1][c] * pdf / mixtureValue(mix.material, wo, wi, c) - 1)));
    }
    EXPECT_LE(worstPdf, 1e-4) << mix.name;
    EXPECT_LE(worstWeight, 1e-4) << mix.name;
    measured("relative error of the density", worstPdf, 1e-4);
    measured("relative error of the weight", worstWeight, 1e-4);
    if (mix.material.alpha == 1.0f && mix.chance == 1.0f) EXPECT_NEAR(below / samples, 0.5, 5e-3) << mix.name;
    if (mix.chance + mix.material.coatChance == 0.0f) EXPECT_EQ(below, 0.0) << mix.name;
  }
}

TEST_F(Lobes, row25_densities_integrate_to_one_minus_what_is_rejected) {
  for (const float alpha : {0.1f, 0.3f, 0.6f, 1.0f})
    for (const double mu : {0.1, 0.5, 1.0}) {
      const std::vector<Facet> nodes = facets(double(alpha), 256, 128);
      const glm::dvec3 wo = direction(mu, 0.0);
      Rows rows;
      double rejected = 0;
      for (const Facet& node : nodes) {
        rows.insert(rows.end(),
                    {glm::vec4(glm::vec3(wo), alpha), glm::vec4(glm::vec3(reflected(wo, node.m)), 0)});
        if (reflected(wo, node.m).z <= 0)
          rejected += double(oracle::visiblePdf(wo, node.m, alpha)) * node.solidAngle;
      }
      const Rows answers = run(bsdf, {.operation = 3, .rowsIn = 2}, rows);
      double sum = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        sum += double(answers[i].w) * 4.0 * std::max(0.0, dot(wo, nodes[i].m)) * nodes[i].solidAngle;
      EXPECT_NEAR(sum, 1.0 - rejected, 1e-3) << "alpha " << alpha << ", cosine " << mu;
      measured("error of the integral of the density", std::fabs(sum - 1 + rejected), 1e-3);
    }
}

TEST_F(Lobes, row22_the_mean_weight_of_white_facets_is_their_albedo) {
  Mixture mix{"white", {}, 1.0, 1.0f};
  mix.material.alpha = 1.0f;
  const Rows drawn =
      drawMixture(mix, [](const Kernel& k, const Task& t, const Rows& r) { return run(k, t, r); });
  double sum = 0, squares = 0;
  for (std::size_t i = 1; i < drawn.size(); i += 3)
    sum += double(drawn[i].x), squares += std::pow(double(drawn[i].x), 2);
  const double mean = sum / samples, sigma = std::sqrt((squares / samples - mean * mean) / samples);
  EXPECT_NEAR(mean, 1.0 - std::log(2.0), 3 * sigma);
  measured("error of the mean weight, standard errors", std::fabs(mean - 1.0 + std::log(2.0)) / sigma, 3);
}

TEST_F(Lobes, a_mirror_reflects_and_weighs_by_fresnel) {
  Material mirror = gltf({0.9f, 0.6f, 0.3f}, 1.0f, 0.0f);
  mirror.lobes = mirrorBit + glossyBit;
  Rows rows;
  pushBsdf(rows, mirror, glm::vec3(direction(0.5, 1.0)), {0.3f, 0.7f, 0}, 1.0f);
  const Rows answers = run(bsdf, {.operation = 1, .rowsIn = bsdfRows, .rowsOut = 3}, rows);
  const glm::dvec3 wo = xyz(rows[0]);
  EXPECT_LT(length(xyz(answers[0]) - glm::dvec3(-wo.x, -wo.y, wo.z)), 1e-6);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(answers[1][c], oracle::schlick(mirror.f0[c], 1, 0.5L), 1e-6);
  EXPECT_EQ(answers[2], glm::vec4(0)) << "a mirror has no density for other strategies";
}

TEST_F(Lobes, row31_two_strategies_share_each_sample_fully) {
  const float inf = INFINITY;
  Rows rows = {{inf, 1, 0, 0}, {1, inf, 0, 0},     {0, 1, 0, 0},
               {inf, 0, 0, 0}, {2e19, 1e19, 0, 0}, {1e-30, 1e30, 0, 0}};
  Random random(31);
  for (int i = 0; i < 100000; ++i) rows.emplace_back(random.decades(-30, 30), random.decades(-30, 30), 0, 0);
  const Rows answers = run(sampling, {.operation = 0}, rows);
  double worst = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_NEAR(answers[i].x + answers[i].y, 1.0f, 1e-6) << rows[i].x << " and " << rows[i].y;
    ASSERT_GE(answers[i].x, 0.0f);
    worst = std::max(worst, std::fabs(double(answers[i].x + answers[i].y) - 1));
  }
  measured("error of the sum of weights", worst, 1e-6);
  EXPECT_EQ(answers[0].x, 1.0f);
  EXPECT_EQ(answers[2].x, 0.0f);
  EXPECT_NEAR(answers[4].x, 0.8f, 1e-6);
}

TEST_F(Lobes, the_chance_of_the_specular_lobe_never_starves_a_lobe) {
  Random random(251);
  Rows rows;
  pushBsdf(rows, gltf(glm::vec3(0.0f), 1.0f, 0.5f), {0, 0, 1}, {0, 0, 1}, 0);  // no diffuse
  Material chalk = gltf(glm::vec3(0.5f), 0.0f, 0.5f, 0.0f);
  chalk.f90 = glm::vec3(0.0f), chalk.dielectricF90 = 0.0f;
  pushBsdf(rows, chalk, {0, 0, 1}, {0, 0, 1}, 0);
  for (int i = 0; i < 1000; ++i)
    pushBsdf(rows, gltf(glm::vec3(random.uniform(0.01, 1)), float(random.uniform(0, 0.99)), 0.5f),
             glm::vec3(direction(random.uniform(), 0)), {0, 0, 1}, 0);
  const Rows answers = run(bsdf, {.operation = 6, .rowsIn = bsdfRows}, rows);
  EXPECT_EQ(answers[0].x, 1.0f);
  EXPECT_EQ(answers[1].x, 0.0f);
  for (std::size_t i = 2; i < answers.size(); ++i)
    ASSERT_TRUE(answers[i].x >= 0.1f && answers[i].x <= 0.9f) << i;
}

}  // namespace
}  // namespace steradian::kernel
