// SPDX-License-Identifier: MIT
// Questions for kernel_bsdf.comp, and the quadrature over microfacets that several tests share.
#pragma once
#include <algorithm>
#include <cmath>

#include "shaders/kernel_bsdf.comp.h"
#include "tests/shaders/kernel.hpp"
#include "tests/shaders/oracle.hpp"

namespace steradian::kernel {

inline const Kernel bsdf{kernel_bsdf_spirv, "bsdf"};

inline constexpr float diffuseBit = 1, glossyBit = 2, mirrorBit = 4, transmissionBit = 8, coatBit = 16,
                       edgeBit = 32;
inline constexpr std::size_t bsdfRows = 9;

struct Material {
  glm::vec3 diffuse{0.0f}, f0{1.0f};
  glm::vec3 f90{1.0f};
  float dielectricF0 = 0.0f, dielectricF90 = 0.0f;
  float alpha = 0.5f;
  float lobes = glossyBit;
  glm::vec3 edge{0.0f};
  float exact = 0.0f, exactLoss = 0.0f, diffusePassed = 0.0f;
  glm::vec3 transmit{0.0f};
  float eta = 1.5f;
  bool thin = false;
  float coat = 0.0f, coatAlpha = 1.0f;
  float coatChance = 0.0f;
};

/// glTF's mixture (appendix B) as the host and scene.glsl make it.
inline Material gltf(glm::vec3 albedo, float metallic, float alpha, float dielectricF0 = 0.04f) {
  return {albedo * (1.0f - metallic),
          glm::mix(glm::vec3(dielectricF0), albedo, metallic),
          glm::vec3(1.0f),
          dielectricF0,
          1.0f,
          alpha,
          diffuseBit + glossyBit};
}

/// The same with other lobes switched on.
inline Material lobes(Material material, float bits) {
  material.lobes = bits;
  return material;
}

inline void pushBsdf(Rows& rows, const Material& m, glm::vec3 wo, glm::vec3 second, float chance) {
  rows.insert(rows.end(),
              {glm::vec4(wo, m.alpha), glm::vec4(second, chance), glm::vec4(m.diffuse, m.dielectricF0),
               glm::vec4(m.f0, m.dielectricF90), glm::vec4(m.f90, m.lobes), glm::vec4(m.edge, m.exact),
               glm::vec4(m.transmit, m.eta), glm::vec4(m.coat, m.coatAlpha, m.coatChance, 0),
               glm::vec4(m.thin, m.exactLoss, m.diffusePassed, 0)});
}

inline glm::dvec3 direction(double cosine, double azimuth) {
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

/// One node of the midpoint rule over the hemisphere of facets, fine where GGX of this alpha is large.
struct Facet {
  glm::dvec3 m;
  double solidAngle;
};

inline std::vector<Facet> facets(double alpha, int steps, int azimuths) {
  std::vector<Facet> nodes;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) / steps,
                 rest = (1.0 - s) * (1.0 - s);  // rest = 1 - q, tan^2 = alpha^2 q / (1 - q)
    const double tan2 = alpha * alpha * (1.0 - rest) / rest;
    const double dTan2 = alpha * alpha / (rest * rest) * 2.0 * (1.0 - s) / steps;
    const double ring = 0.5 * std::pow(1.0 + tan2, -1.5) * dTan2 * 2.0 * M_PI / azimuths;
    for (int k = 0; k < azimuths; ++k)
      nodes.push_back({direction(1.0 / std::sqrt(1.0 + tan2), (k + 0.5) * 2.0 * M_PI / azimuths), ring});
  }
  return nodes;
}

inline glm::dvec3 reflected(glm::dvec3 wo, glm::dvec3 m) {
  return 2.0 * dot(wo, m) * m - wo;
}

}  // namespace steradian::kernel
