// SPDX-License-Identifier: MIT
// Albedo against roughness, and the tables below it, by the numbers in the literature.
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/energy_table.hpp"
#include "renderer/facet_albedo.hpp"
#include "renderer/furnace_curve.hpp"
#include "shaders/gpu_types.h"
#include "tests/measured.hpp"

namespace steradian {
namespace {

Material white(float metallic) {
  Material m;
  m.albedo = glm::vec3(1.0f);
  m.metallic = metallic;
  return m;
}

TEST(FacetAlbedo, row22_is_that_of_the_literature) {
  const Quadrature rule = gaussLegendre(48), cosines = gaussLegendre(16);
  EXPECT_NEAR(facetAlbedo(1.0, 1.0, rule).white(), 1.0 - std::log(2.0), 1e-6);
  EXPECT_NEAR(facetAlbedo(0.25, 1.0, rule).white(), 0.915812, 1e-4);
  const double table[][2] = {{0.1, .9997}, {0.3, .9772}, {0.5, .8823},
                             {0.7, .7074}, {0.9, .5024}, {1.0, .4092}};
  for (const auto& [roughness, expected] : table) {
    double mean = 0.0;
    for (std::size_t i = 0; i < cosines.x.size(); ++i)
      mean +=
          2.0 * cosines.w[i] * cosines.x[i] * facetAlbedo(roughness * roughness, cosines.x[i], rule).white();
    EXPECT_NEAR(mean, expected, 2e-3) << "roughness " << roughness;
    measured("error of the mean albedo", std::abs(mean - expected), 2e-3);
  }
}

TEST(FacetAlbedo, SmoothFacetsReflectSchlicksCurve) {
  const FacetAlbedo smooth = facetAlbedo(0.0, 0.3, gaussLegendre(16));
  EXPECT_NEAR(smooth.f90, std::pow(0.7, 5), 1e-4);
  EXPECT_NEAR(smooth.white(), 1.0, 1e-4);
}

/// The cell of a table that the shader reads, and where in it.
struct Cell {
  std::size_t index;
  double fx, fy;
};
Cell cellOf(double roughness, double mu) {
  const double x = std::sqrt(roughness) * gpu::ENERGY_CELLS, y = std::pow(mu, 0.25) * gpu::ENERGY_CELLS;
  return {std::size_t(y) * gpu::ENERGY_CELLS + std::size_t(x), x - std::floor(x), y - std::floor(y)};
}
template <class Corners>
double at(const Cell& cell, const Corners& cornersOf) {
  const glm::dvec4 c(cornersOf(cell.index));
  const double fx = cell.fx, fy = cell.fy;
  return (c.x * (1 - fx) + c.y * fx) * (1 - fy) + (c.z * (1 - fx) + c.w * fx) * fy;
}
/// White facets.
double tableAt(double roughness, double mu) {
  const std::vector<glm::vec4>& table = energyTable();
  return at(cellOf(roughness, mu), [&](std::size_t cell) { return table[2 * cell] + table[2 * cell + 1]; });
}

TEST(EnergyTable, row23_between_its_nodes_never_gains_half_a_percent) {
  ASSERT_EQ(energyTable().size(), gpu::ENERGY_ROWS);
  const Quadrature rule = gaussLegendre(48);
  // From the smoothest facets that are no mirror, and mostly at grazing angles.
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 40; ++j) {
      const double roughness = 0.0317 + 0.968 * std::pow((i + 0.37) / 60, 1.5);
      const double mu = std::pow((j + 0.41) / 40, 2.2);
      const double gain = facetAlbedo(roughness * roughness, mu, rule).white() / tableAt(roughness, mu);
      EXPECT_LE(gain, 1.005) << "roughness " << roughness << ", cosine " << mu;
      measured("gain", gain - 1.0, 0.005);
      EXPECT_GE(gain, mu > 0.1 ? 0.995 : 0.985) << "roughness " << roughness << ", cosine " << mu;
    }
}

TEST(GlassTables, row23_between_their_nodes_gain_little) {
  GlassTables tables;
  const Quadrature rule = gaussLegendre(48);
  for (const float ior : {1.05f, 1.33f, 1.5f, 2.4f}) {
    const auto table = tables.of(ior);
    ASSERT_EQ(table->size(), gpu::GLASS_ROWS);
    for (const bool inside : {false, true})
      for (int i = 0; i < 30; ++i)
        for (int j = 0; j < 20; ++j) {
          const double roughness = 0.05 + 0.95 * (i + 0.37) / 30, mu = std::pow((j + 0.41) / 20, 2.2);
          const std::size_t first = inside ? gpu::GLASS_CELLS : 0;
          const double albedo =
              glassAlbedo(roughness * roughness, mu, inside ? 1.0 / ior : double(ior), rule).white();
          const double gain =
              albedo / at(cellOf(roughness, mu), [&](std::size_t cell) { return (*table)[first + cell]; });
          // Seen from within, total reflection puts a crease into the table, the steeper the nearer the index
          // is to 1.
          const double gate = inside && ior < 1.1f ? 0.03 : mu < 0.1 ? 0.015 : inside ? 0.01 : 0.005;
          EXPECT_NEAR(gain, 1.0, gate) << "roughness " << roughness << ", cosine " << mu << ", index " << ior
                                       << (inside ? " inside" : "");
          measured(mu < 0.1 ? "gain or loss of glass at grazing angles" : "gain or loss of glass",
                   std::abs(gain - 1.0), gate);
        }
  }
  EXPECT_EQ(tables.of(1.5f), tables.of(1.5f)) << "kept";
}

TEST(FurnaceCurve, WhiteSurfacesLieAtOneWhenCompensated) {
  for (const float metallic : {0.0f, 0.5f, 1.0f})
    for (const float coat : {0.0f, 1.0f}) {
      Material m = white(metallic);
      m.clearcoat = coat;
      for (const glm::vec3 albedo : furnaceCurve(m, 9)) EXPECT_NEAR(albedo.x, 1.0f, 1e-5f);
    }
}

TEST(FurnaceCurve, SingleScatteringDarkensRoughMetal) {
  const std::vector<glm::vec3> curve = furnaceCurve(white(1.0f), 11, false);
  EXPECT_NEAR(curve[0].x, 1.0f, 2e-3f);
  EXPECT_NEAR(curve[5].x, 0.8823f, 5e-3f);
  EXPECT_NEAR(curve[10].x, 0.4092f, 5e-3f);
  for (std::size_t i = 1; i < curve.size(); ++i) EXPECT_LE(curve[i].x, curve[i - 1].x + 1e-3f);
}

TEST(FurnaceCurve, CompensationSaturatesColour) {
  Material gold = white(1.0f);
  gold.albedo = {0.95f, 0.7f, 0.3f};
  const glm::vec3 rough = furnaceCurve(gold, 2)[1], smooth = furnaceCurve(gold, 2)[0];
  EXPECT_LT(rough.z / rough.x, smooth.z / smooth.x);
}

}  // namespace
}  // namespace steradian
