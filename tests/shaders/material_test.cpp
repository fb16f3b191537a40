// SPDX-License-Identifier: MIT
// Whole materials: what they give back of even light, and where they send it.
#include "renderer/scene/fresnel.hpp"
#include "tests/shaders/chi_square.hpp"
#include "tests/shaders/material_rows.hpp"

namespace steradian::kernel {
namespace {

using Surface = steradian::Material;

class Materials : public KernelTest {
 protected:
  static Share shareOf(const Surface& m, double mu, float flags, bool compensation, int channel = 0) {
    Rows rows;
    pushSamples(rows, 0, mu, flags);
    const double eta = flags == insideBit ? 1.0 / m.ior : double(m.ior);
    return meanShare(run(materialKernel, materialTask(0, {m}, compensation), rows), 0,
                     flags == thinBit ? 1.0 : eta * eta, channel);
  }
};

Surface white(float roughness, float metallic) {
  Surface m;
  m.albedo = glm::vec3(1.0f);
  m.roughness = roughness;
  m.metallic = metallic;
  return m;
}
Surface glass(float roughness) {
  Surface m = white(roughness, 0.0f);
  m.transmission = 1.0f;
  return m;
}

/// Shares of many materials at several cosines in one go.
struct Furnace {
  std::vector<Surface> materials;
  std::vector<double> cosines{0.03, 0.08, 0.15, 0.4, 0.7, 1.0};
};
using Run = std::function<Rows(const Task&, const Rows&)>;
/// Of each material the share that lies farthest from 1.
std::vector<double> expectNothingLost(const Furnace& furnace, const Run& run) {
  Rows rows;
  for (std::size_t m = 0; m < furnace.materials.size(); ++m)
    for (const double mu : furnace.cosines) pushSamples(rows, m, mu, 0);
  const Rows answers = run(materialTask(0, furnace.materials, true), rows);
  std::vector<double> farthest(furnace.materials.size(), 1.0);
  for (std::size_t i = 0; i < furnace.materials.size() * furnace.cosines.size(); ++i) {
    const double mu = furnace.cosines[i % furnace.cosines.size()];
    const Surface& m = furnace.materials[i / furnace.cosines.size()];
    const double albedo = meanShare(answers, i * samplesPerShare, 1).total();
    measured(mu > 0.1 ? "loss or gain" : "loss or gain at grazing angles", std::fabs(albedo - 1.0),
             mu > 0.1 ? 0.005 : 0.015);
    measured("gain", albedo - 1.0, 0.005);
    EXPECT_NEAR(albedo, 1.0, mu > 0.1 ? 0.005 : 0.015)
        << "roughness " << m.roughness << ", metallic " << m.metallic << ", coat " << m.clearcoat
        << ", cosine " << mu;
    EXPECT_LE(albedo, 1.005);
    double& worst = farthest[i / furnace.cosines.size()];
    if (std::fabs(albedo - 1.0) > std::fabs(worst - 1.0)) worst = albedo;
  }
  return farthest;
}

/// Seven roughnesses down, seven metallicities across, both from 0 to 1.
void printTable(const std::vector<double>& shares) {
  std::printf("furnace, share of the cosine that lies farthest from 1; metallic 0 to 1 across\n");
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (i % 7 == 0) std::printf("roughness %.3f", double(i / 7) / 6);
    std::printf(i % 7 == 6 ? " %.4f\n" : " %.4f", shares[i]);
  }
}

TEST_F(Materials, row23_white_surfaces_lose_nothing_when_compensated) {
  Furnace furnace;
  for (int r = 0; r < 7; ++r)
    for (int m = 0; m < 7; ++m) furnace.materials.push_back(white(float(r) / 6, float(m) / 6));
  printTable(
      expectNothingLost(furnace, [](const Task& t, const Rows& q) { return run(materialKernel, t, q); }));
}

TEST_F(Materials, row23_nor_do_smooth_ones_between_the_nodes_of_the_table) {
  Furnace furnace;
  for (const float roughness : {0.034f, 0.048f, 0.07f, 0.11f, 0.23f})
    furnace.materials.push_back(white(roughness, 1.0f));
  furnace.cosines = {0.003, 0.006, 0.01, 0.017, 0.03, 0.06};
  expectNothingLost(furnace, [](const Task& t, const Rows& q) { return run(materialKernel, t, q); });
}

TEST_F(Materials, row23_neither_do_coated_ones) {
  Furnace furnace;
  for (const float coatRoughness : {0.0f, 0.4f, 1.0f})
    for (const float metallic : {0.0f, 0.5f, 1.0f}) {
      furnace.materials.push_back(white(0.6f, metallic));
      furnace.materials.back().clearcoat = 0.8f;
      furnace.materials.back().clearcoatRoughness = coatRoughness;
    }
  furnace.cosines = {0.15, 0.5, 1.0};
  expectNothingLost(furnace, [](const Task& t, const Rows& q) { return run(materialKernel, t, q); });
}

TEST_F(Materials, row23_uncompensated_metal_gives_back_its_single_scatter_albedo) {
  const double single = shareOf(white(1.0f, 1.0f), 1.0, 0, false).total();
  EXPECT_NEAR(single, 1.0 - std::log(2.0), 2e-3);
  measured("error of the single-scatter albedo", std::fabs(single - 1.0 + std::log(2.0)), 2e-3);
  EXPECT_NEAR(shareOf(white(1.0f, 1.0f), 1.0, 0, true).total(), 1.0, 3e-3);
}

TEST_F(Materials, row27_smooth_glass_splits_light_by_fresnel) {
  for (const bool inside : {false, true})
    for (const double mu : {0.2, 0.5, 0.74, 0.8, 1.0}) {
      const Share share = shareOf(glass(0.0f), mu, inside ? insideBit : 0, true);
      const double exact = double(oracle::fresnel(mu, inside ? 1.0L / 1.5L : 1.5L));
      EXPECT_NEAR(share.total(), 1.0, 2e-3) << mu;
      EXPECT_NEAR(share.reflected, exact, 2e-3) << "cosine " << mu;
      measured("error of the reflected share", std::fabs(share.reflected - exact), 2e-3);
      if (inside && mu < 0.745) {
        EXPECT_EQ(share.transmitted, 0.0) << "total reflection";
      }
    }
}

TEST_F(Materials, row35_a_sheet_of_glass_passes_what_both_faces_leave) {
  for (const float roughness : {0.0f, 0.1f}) {
    const Share share = shareOf(glass(roughness), 1.0, thinBit, true);
    EXPECT_NEAR(share.transmitted, 0.9230769, 0.005) << roughness;
    measured("error of the transmitted share", std::fabs(share.transmitted - 0.9230769), 0.005);
    EXPECT_NEAR(share.total(), 1.0, 0.005) << roughness;
  }
}

TEST_F(Materials, rough_glass_loses_only_what_is_masked) {
  for (const float flags : {0.0f, insideBit, thinBit})
    for (const double mu : {0.3, 0.6, 0.9}) {
      EXPECT_NEAR(shareOf(glass(0.2f), mu, flags, true).total(), 1.0, 0.02) << flags << ", " << mu;
      const double rough = shareOf(glass(0.6f), mu, flags, true).total();
      EXPECT_LE(rough, 1.005) << flags << ", " << mu;
      EXPECT_GE(rough, 0.7) << flags << ", " << mu;
    }
}

TEST_F(Materials, a_metal_reflects_its_edge_tint_at_82_degrees) {
  Surface m = white(0.0f, 1.0f);
  m.albedo = {0.9f, 0.5f, 0.2f};
  m.edgeTint = {0.8f, 0.95f, 0.6f};
  for (int c = 0; c < 3; ++c) {
    const double schlick = double(oracle::schlick(m.albedo[c], 1, 1.0L / 7));
    EXPECT_NEAR(shareOf(m, 1.0 / 7, 0, true, c).total(), m.edgeTint[c] * schlick, 1e-5);
    EXPECT_NEAR(shareOf(m, 1.0, 0, true, c).total(), m.albedo[c], 1e-5) << "head-on";
  }
}

/// Density of passing light through visible facets (Walter et al. 2007, eq. 17), or straight through a sheet.
oracle::Real passedPdf(oracle::Vec wo, oracle::Vec wi, oracle::Real eta, oracle::Real alpha, bool thin) {
  if (wi.z >= 0) return 0;
  if (thin) return oracle::reflectedPdf(wo, oracle::Vec(wi.x, wi.y, -wi.z), alpha);
  oracle::Vec h = glm::normalize(wo + eta * wi);
  if (h.z < 0) h = -h;
  const oracle::Real oh = glm::dot(wo, h), ih = glm::dot(wi, h), sum = oh + eta * ih;
  return oh <= 0 || ih >= 0 ? 0 : oracle::visiblePdf(wo, h, alpha) * eta * eta * -ih / (sum * sum);
}

struct Passing {
  float flags;
  double mu;
  float roughness;
};
constexpr Passing passings[] = {{0, 0.7, 0.6f}, {0, 0.2, 0.8f}, {insideBit, 0.9, 0.5f}, {thinBit, 0.5, 0.6f}};

const double significance = 1 - std::pow(0.99, 1.0 / std::size(passings));  // Sidak

TEST_F(Materials, row24_light_through_rough_glass_has_its_density) {
  constexpr int samples = 1'000'000;
  for (const Passing& p : passings) {
    const glm::vec4 wo(glm::vec3(direction(p.mu, 0.7)), 0);
    Random random(24);
    Rows rows;
    for (int i = 0; i < samples; ++i)
      rows.insert(rows.end(),
                  {wo, glm::vec4(random.uniform(0, 1 - 1e-7), random.uniform(0, 1 - 1e-7), 0, p.flags)});
    const Rows drawn = run(materialKernel, materialTask(0, {glass(p.roughness)}, false), rows);
    const oracle::Vec o(xyz(wo));
    const oracle::Real a = p.roughness * p.roughness, eta = p.flags == insideBit ? 1 / 1.5L : 1.5L;
    const oracle::Real f = oracle::fresnel(o.z, eta), r = p.flags == thinBit ? 2 * f / (1 + f) : f;
    const double chance = std::clamp(1.0 - double(r), 0.1, 0.9);
    const auto density = [&](oracle::Vec wi) {
      return chance * passedPdf(o, wi, eta, a, p.flags == thinBit) +
             (wi.z > 0 ? (1 - chance) * oracle::reflectedPdf(o, wi, a) : 0);
    };
    Rows kept = drawn;  // a sample on the wrong side of the horizon is lost: it has no density
    for (std::size_t i = 0; i < kept.size(); i += 2)
      if (kept[i].w == 0) kept[i] = glm::vec4(0, 0, -2, 0);
    expectDensity(chiSquare(kept, 2, density, {-1, 1}), significance, "cosine " + std::to_string(p.mu));
    double worst = 0;
    for (std::size_t i = 0; i < drawn.size(); i += 240) {
      if (drawn[i].w == 0 || std::fabs(drawn[i].z) < 1e-3f) continue;
      worst = std::max(worst, std::fabs(double(drawn[i].w / density(oracle::Vec(xyz(drawn[i]))) - 1)));
    }
    EXPECT_LE(worst, 1e-3) << "row 25: the density stated";
    measured("relative error of the density", worst, 1e-3);
  }
}

TEST_F(Materials, row26_glass_is_reciprocal_but_for_the_compression_of_radiance) {
  Random random(26);
  Rows there, back;
  for (int i = 0; i < 20000; ++i) {
    const glm::vec3 a(direction(random.uniform(0.1, 1), random.uniform(0, 6.3)));
    const glm::vec3 b(direction(random.uniform(0.1, 1), random.uniform(0, 6.3)));
    // From outside, and from inside with the frame turned to that side
    there.insert(there.end(), {glm::vec4(a, 0), glm::vec4(b.x, b.y, -b.z, 0)});
    back.insert(back.end(), {glm::vec4(b, 0), glm::vec4(a.x, a.y, -a.z, insideBit)});
  }
  const Task task = materialTask(1, {glass(0.7f)}, false);
  const Rows f = run(materialKernel, task, there), g = run(materialKernel, task, back);
  int compared = 0;
  double worst = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double one = double(f[i].x) / -double(there[2 * i + 1].z) * 2.25;
    const double other = double(g[i].x) / -double(back[2 * i + 1].z);
    if (one < 1e-6) continue;
    // Facets seen edge-on from outside lie at the critical angle inside: there a float has few digits of 1 -
    // F.
    ASSERT_NEAR(other, one, 1e-3 * one + 1e-4) << i;
    worst = std::max(worst, std::fabs(other - one) / (1e-3 * one + 1e-4));
    ++compared;
  }
  measured("difference / (0.001 f + 0.0001)", worst, 1);
  EXPECT_GT(compared, 4000);
}

TEST_F(Materials, grazing_and_degenerate_materials_stay_finite) {
  std::vector<Surface> materials;
  for (const float roughness : {0.0f, 0.032f, 0.2f, 1.0f})
    for (const float ior : {1.0f, 1.0001f, 1.5f, 4.0f})
      for (const float metallic : {0.0f, 0.5f}) {
        materials.push_back(glass(roughness));
        materials.back().ior = ior;
        materials.back().metallic = metallic;
        materials.back().clearcoat = metallic;
        materials.back().albedo = glm::vec3(metallic);
      }
  Rows rows;
  for (std::size_t m = 0; m < materials.size(); ++m)
    for (const float flags : {0.0f, insideBit, thinBit})
      for (const double mu : {1e-7, 1e-3, 0.5, 1.0})
        for (int i = 0; i < 64; ++i)
          rows.insert(rows.end(), {glm::vec4(glm::vec3(direction(mu, 1)), float(m)),
                                   glm::vec4((float(i % 8) + 0.5f) / 8, float(i / 8) / 8, 0, flags)});
  const Rows answers = run(materialKernel, materialTask(0, materials, true), rows);
  for (std::size_t i = 0; i < answers.size(); ++i)
    for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(answers[i][c])) << i;
}

}  // namespace
}  // namespace steradian::kernel
