// SPDX-License-Identifier: MIT
#include "renderer/furnace_curve.hpp"

#include <cassert>

#include "renderer/facet_albedo.hpp"

namespace steradian {

namespace {

constexpr double coatF0 = 0.04;

double single(const FacetAlbedo& facets, double f0, double f90) {
  return f0 * facets.f0 + f90 * facets.f90;
}
// Turquin 2019
double gain(const FacetAlbedo& facets, double f0, bool compensated) {
  return compensated ? 1.0 + f0 * (1.0 / facets.white() - 1.0) : 1.0;
}

// What facets give back of white light: reflected, and passed by glass; opaque bases get what is not
// reflected.
GlassAlbedo dielectricAlbedo(const Material& m, const FacetAlbedo& facets, const GlassAlbedo& glass,
                             bool compensated) {
  if (m.transmission > 0.0f) {
    const double all = compensated ? 1.0 / glass.white() : 1.0;
    return {all * glass.reflected, all * glass.transmitted};
  }
  const double ratio = (double(m.ior) - 1.0) / (double(m.ior) + 1.0), f0 = m.specular * ratio * ratio;
  const double reflected = single(facets, f0, m.specular) * gain(facets, f0, compensated);
  return {reflected, 1.0 - reflected};
}

// Seen at one cosine: metal and dielectric over their base, below the coat.
glm::dvec3 albedoOf(const Material& m, const FacetAlbedo& facets, const GlassAlbedo& glass,
                    const FacetAlbedo& coat, bool compensated) {
  const GlassAlbedo plastic = dielectricAlbedo(m, facets, glass, compensated);
  const double below = glm::mix(1.0 - plastic.reflected, plastic.transmitted, double(m.transmission));
  const double coated = m.clearcoat * single(coat, coatF0, 1.0) * gain(coat, coatF0, compensated);
  glm::dvec3 albedo;
  for (int c = 0; c < 3; ++c) {
    const double metal = single(facets, m.albedo[c], 1.0) * gain(facets, m.albedo[c], compensated);
    const double dielectric = plastic.reflected + m.albedo[c] * below;
    albedo[c] = (1.0 - coated) * glm::mix(dielectric, metal, double(m.metallic)) + coated;
  }
  return albedo;
}

}  // namespace

std::vector<glm::vec3> furnaceCurve(const Material& material, int points, bool compensated) {
  assert(points >= 2);
  const Quadrature cosines = gaussLegendre(6), rule = gaussLegendre(8);
  const double coatAlpha = double(material.clearcoatRoughness) * material.clearcoatRoughness;
  std::vector<FacetAlbedo> coat;
  for (const double mu : cosines.x) coat.push_back(facetAlbedo(coatAlpha, mu, rule));
  std::vector<glm::vec3> curve;
  for (int i = 0; i < points; ++i) {
    const double roughness = double(i) / (points - 1);
    glm::dvec3 mean(0.0);
    for (std::size_t k = 0; k < cosines.x.size(); ++k) {
      const double mu = cosines.x[k];
      const double alpha = roughness * roughness;
      const FacetAlbedo facets = facetAlbedo(alpha, mu, rule);
      const GlassAlbedo glass =
          material.transmission > 0.0f ? glassAlbedo(alpha, mu, material.ior, rule) : GlassAlbedo();
      mean += 2.0 * mu * cosines.w[k] * albedoOf(material, facets, glass, coat[k], compensated);
    }
    curve.emplace_back(mean);
  }
  return curve;
}

}  // namespace steradian
