// SPDX-License-Identifier: MIT
// Whole materials: what they give back of even light, and where they send it.
#include "renderer/facet_albedo.hpp"
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

/// Glass seen from outside, from within and as a sheet, each at these cosines. Total reflection puts a crease
/// into what is seen from within.
void expectGlassLosesNothing(const std::vector<Surface>& materials, const Run& run) {
  const double cosines[] = {0.05, 0.15, 0.4, 0.7, 1.0};
  for (const float flags : {0.0f, insideBit, thinBit}) {
    Rows rows;
    for (std::size_t m = 0; m < materials.size(); ++m)
      for (const double mu : cosines) pushSamples(rows, m, mu, flags);
    const Rows answers = run(materialTask(0, materials, true), rows);
    for (std::size_t i = 0; i < materials.size() * std::size(cosines); ++i) {
      const Surface& m = materials[i / std::size(cosines)];
      const double mu = cosines[i % std::size(cosines)],
                   eta = flags == insideBit ? 1.0 / m.ior : double(m.ior);
      const double share =
          meanShare(answers, i * samplesPerShare, flags == thinBit ? 1.0 : eta * eta).total();
      const double gate = mu < 0.1 ? 0.015 : flags == insideBit ? 0.01 : 0.005;
      EXPECT_NEAR(share, 1.0, gate) << "roughness " << m.roughness << ", ior " << m.ior << ", transmission "
                                    << m.transmission << ", cosine " << mu << ", flags " << flags;
      measured(mu > 0.1 ? "loss or gain of glass" : "loss or gain of glass at grazing angles",
               std::fabs(share - 1.0), gate);
    }
  }
}

TEST_F(Materials, row23_nor_does_rough_glass_from_either_side_or_as_a_sheet) {
  std::vector<Surface> materials;
  for (const float roughness : {0.15f, 0.33f, 0.5f, 0.77f, 1.0f})
    for (const float ior : {1.1f, 1.5f, 2.4f}) {
      materials.push_back(glass(roughness));
      materials.back().ior = ior;
    }
  expectGlassLosesNothing(materials, [](const Task& t, const Rows& q) { return run(materialKernel, t, q); });
}

TEST_F(Materials, row23_partly_transmitting_glass_keeps_its_energy) {
  std::vector<Surface> materials;
  for (const float transmission : {0.1f, 0.5f, 0.9f})
    for (const float roughness : {0.0f, 0.1f, 0.3f, 0.6f, 1.0f})
      for (const float ior : {1.1f, 1.5f, 2.4f}) {
        materials.push_back(glass(roughness));
        materials.back().ior = ior;
        materials.back().transmission = transmission;
      }
  expectGlassLosesNothing(materials, [](const Task& t, const Rows& q) { return run(materialKernel, t, q); });
}

TEST_F(Materials, uncompensated_rough_glass_loses_what_is_masked) {
  const Quadrature rule = gaussLegendre(48);
  for (const bool inside : {false, true})
    for (const double mu : {0.3, 0.6, 0.9})
      for (const float roughness : {0.2f, 0.6f, 1.0f}) {
        const Share share = shareOf(glass(roughness), mu, inside ? insideBit : 0, false);
        const GlassAlbedo expected = glassAlbedo(roughness * roughness, mu, inside ? 1 / 1.5 : 1.5, rule);
        EXPECT_NEAR(share.reflected, expected.reflected, 0.005) << roughness << ", " << mu;
        EXPECT_NEAR(share.transmitted, expected.transmitted, 0.005) << roughness << ", " << mu;
        EXPECT_LT(expected.white(), roughness > 0.5f ? 0.99 : 1.0);
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

/// Share that a facet mirrors, by its cosine to either direction.
oracle::Real mirroredShare(oracle::Real cosine, oracle::Real eta, bool thin) {
  const oracle::Real f = oracle::fresnel(cosine, eta);
  return thin ? 2 * f / (1 + f) : f;
}

/// Density of light that mirrored facets send above the surface, each drawn as often as it mirrors.
oracle::Real mirroredPdf(oracle::Vec wo, oracle::Vec wi, oracle::Real eta, oracle::Real alpha, bool thin) {
  if (wi.z <= 0) return 0;
  return mirroredShare(glm::dot(wo, glm::normalize(wo + wi)), eta, thin) *
         oracle::reflectedPdf(wo, wi, alpha);
}

/// Of passing light through visible facets (Walter et al. 2007, eq. 17), or straight through a sheet.
oracle::Real passedPdf(oracle::Vec wo, oracle::Vec wi, oracle::Real eta, oracle::Real alpha, bool thin) {
  if (wi.z >= 0) return 0;
  if (thin) {
    const oracle::Vec mirrored(wi.x, wi.y, -wi.z);
    const oracle::Real share = mirroredShare(glm::dot(wo, glm::normalize(wo + mirrored)), eta, true);
    return (1 - share) * oracle::reflectedPdf(wo, mirrored, alpha);
  }
  oracle::Vec h = glm::normalize(wo + eta * wi);
  if (h.z < 0) h = -h;
  const oracle::Real oh = glm::dot(wo, h), ih = glm::dot(wi, h), sum = oh + eta * ih;
  if (oh <= 0 || ih >= 0) return 0;
  return (1 - mirroredShare(oh, eta, false)) * oracle::visiblePdf(wo, h, alpha) * eta * eta * -ih /
         (sum * sum);
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
      rows.insert(rows.end(), {wo, glm::vec4(random.uniform(0, 1 - 1e-7), random.uniform(0, 1 - 1e-7),
                                             random.uniform(0, 1 - 1e-7), p.flags)});
    const Rows drawn = run(materialKernel, materialTask(0, {glass(p.roughness)}, false), rows);
    const oracle::Vec o(xyz(wo));
    const oracle::Real a = p.roughness * p.roughness, eta = p.flags == insideBit ? 1 / 1.5L : 1.5L;
    const bool thin = p.flags == thinBit;
    const auto density = [&](oracle::Vec wi) {
      return passedPdf(o, wi, eta, a, thin) + mirroredPdf(o, wi, eta, a, thin);
    };
    Rows kept = drawn;  // a sample on the wrong side of the horizon is lost: it has no density
    for (std::size_t i = 0; i < kept.size(); i += 2)
      if (kept[i].w == 0) kept[i] = glm::vec4(0, 0, -2, 0);
    expectDensity(chiSquare(kept, 2, density, {-1, 1}), significance, "cosine " + std::to_string(p.mu));
    for (std::size_t i = 0; i < drawn.size(); i += 2)
      if (drawn[i].w != 0)  // a GPU may contract one of the two
        ASSERT_NEAR(drawn[i + 1].w / drawn[i].w, 1.0, device_->description().type == "CPU" ? 0.0 : 1e-5)
            << "row 25: sample.pdf == pdf(sample.wi)";
    double worst = 0;
    for (std::size_t i = 0; i < drawn.size(); i += 60) {
      if (drawn[i].w == 0) continue;
      const oracle::Vec wi(xyz(drawn[i]));
      // Beside total reflection the float cosine itself has fewer digits than the gate.
      const oracle::Real cosine = glm::dot(o, glm::normalize(o + (wi.z > 0 ? 1 : eta) * wi));
      if (!thin && std::fabs(1 - (1 - cosine * cosine) / (eta * eta)) < 0.01L) continue;
      worst = std::max(worst, std::fabs(double(drawn[i].w / density(wi) - 1)));
    }
    EXPECT_LE(worst, 1e-4) << "row 25: the density stated";
    measured("relative error of the density", worst, 1e-4);
  }
}

/// Two directions on either side of a surface that some facet refracts into each other, and that facet's
/// cosine to `outside` (the smaller one: the side of lower index).
struct RefractedPair {
  glm::vec3 outside, inside;
  double cosine;
};
RefractedPair refractedPair(Random& random, double eta) {
  for (;;) {
    const glm::vec3 a(direction(random.uniform(0.01, 1), random.uniform(0, 6.3)));
    const glm::vec3 b(direction(-random.uniform(0.01, 1), random.uniform(0, 6.3)));
    const glm::dvec3 h = -normalize(glm::dvec3(a) + eta * glm::dvec3(b));
    const double cosine = dot(glm::dvec3(a), h);
    if (h.z > 0.01 && cosine > 1e-4 && dot(glm::dvec3(b), h) < -1e-4) return {a, b, cosine};
  }
}

TEST_F(Materials, row26_glass_is_reciprocal_but_for_the_compression_of_radiance) {
  constexpr int pairs = 100'000;
  std::vector<Surface> materials;
  for (const float roughness : {0.4f, 0.7f, 1.0f})
    for (const float ior : {1.33f, 1.5f, 2.42f}) {
      materials.push_back(glass(roughness));
      materials.back().ior = ior;
    }
  Random random(26);
  Rows there, back;
  std::vector<double> cosines;
  for (int i = 0; i < pairs; ++i) {
    const float material = float(std::size_t(i) % materials.size());
    const auto [a, b, cosine] = refractedPair(random, materials[std::size_t(material)].ior);
    // From outside, and from inside with the frame turned to that side
    there.insert(there.end(), {glm::vec4(a, material), glm::vec4(b, 0)});
    back.insert(back.end(), {glm::vec4(b.x, b.y, -b.z, material), glm::vec4(a.x, a.y, -a.z, insideBit)});
    cosines.push_back(cosine);
  }
  const Task task = materialTask(1, materials, false);
  const Rows f = run(materialKernel, task, there), g = run(materialKernel, task, back);
  double worst = 0, worstEdgeOn = 0;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double eta = materials[i % materials.size()].ior;
    const double one = double(f[i].x) / -double(there[2 * i + 1].z) * eta * eta;
    const double other = double(g[i].x) / -double(back[2 * i + 1].z);
    const double difference = std::fabs(other / one - 1);
    // A facet that is seen edge-on: h = wo + eta wi is nearly at right angles to wo, and half a unit in the
    // last place of the directions' components alone moves wo.h, and f with it, by 2e-7 / cosine (the same
    // formulas in long double, inputs moved by that much: up to 1.4e-4 at cosine 0.0013, where the float pair
    // parts by 1.6e-4).
    ASSERT_LE(difference, 1e-5 * std::max(1.0, 0.05 / cosines[i])) << i << ", cosine " << cosines[i];
    double& of = cosines[i] > 0.05 ? worst : worstEdgeOn;
    of = std::max(of, difference * std::min(1.0, cosines[i] / 0.05));
  }
  measured("relative difference of f(l, v) and f(v, l)", worst, 1e-5);
  measured("the same at facets edge-on, * cosine / 0.05", worstEdgeOn, 1e-5);
}

TEST_F(Materials, row26_diffuse_light_behind_smooth_glass_is_reciprocal_and_leaves_what_it_can) {
  Random random(261);
  Surface milk = glass(0.0f);
  milk.transmission = 0.5f;
  Rows there, back;
  for (int i = 0; i < 20'000; ++i) {
    const float flags = i % 2 ? insideBit : 0.0f;
    const glm::vec3 a(direction(random.uniform(0.05, 1), 1)), b(direction(random.uniform(0.05, 1), 4));
    there.insert(there.end(), {glm::vec4(a, 0), glm::vec4(b, flags)});
    back.insert(back.end(), {glm::vec4(b, 0), glm::vec4(a, flags)});
  }
  const Task task = materialTask(1, {milk}, true);
  const Rows f = run(materialKernel, task, there), g = run(materialKernel, task, back);
  const float critical = std::sqrt(1.0f - 1.0f / 2.25f);
  double worst = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const float cosA = there[2 * i].z, cosB = back[2 * i].z;
    const bool kept = i % 2 && std::min(cosA, cosB) < critical;
    if (kept) ASSERT_LE(std::max(f[i].x, g[i].x), 1e-6f) << "total reflection lets nothing out";
    // Beside the critical angle the cosines themselves have too few digits.
    if (i % 2 && std::min(cosA, cosB) < 1.01f * critical) continue;
    worst = std::max(worst, std::fabs(double(f[i].x / cosB) / double(g[i].x / cosA) - 1));
  }
  EXPECT_LE(worst, 1e-5);
  measured("relative difference of diffuse f(l, v) and f(v, l)", worst, 1e-5);
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
          rows.insert(rows.end(),
                      {glm::vec4(glm::vec3(direction(mu, 1)), float(m)),
                       glm::vec4((float(i % 8) + 0.5f) / 8, float(i / 8) / 8, float(i % 3) / 3, flags)});
  const Rows answers = run(materialKernel, materialTask(0, materials, true), rows);
  for (std::size_t i = 0; i < answers.size(); ++i)
    for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(answers[i][c])) << i;
}

}  // namespace
}  // namespace steradian::kernel
