// SPDX-License-Identifier: MIT
// GGX microfacets and Fresnel reflectances from the papers, and albedos by quadrature.
#pragma once
#include <vector>

#include <glm/glm.hpp>

namespace steradian::oracle {

/// Below this a lobe is a perfect mirror.
inline constexpr double kMirrorAlpha = 1e-3;

/// GGX distribution of normals per steradian (Walter et al. 2007, eq. 33).
double ggxD(double alpha, double cosTheta);
/// Smith's Lambda of GGX (Heitz 2014, eq. 72).
double smithLambda(double alpha, double cosTheta);
/// Height-correlated masking and shadowing on one side (Heitz 2014, eq. 99).
double smithG2(double alpha, double cosO, double cosI);

/// (1 - cos)^5 (Schlick 1994, eq. 15).
double schlickWeight(double cosTheta);
/// Unpolarized reflectance between media of index etaO (where the light is) and etaT; 1 beyond the critical
/// angle.
double fresnelDielectric(double cosTheta, double etaO, double etaT);
/// Schlick's reflectance less the dip that makes it `edgeTint` times Schlick's at cos = 1/7 (Kutz, Hasan &
/// Edmondson 2021, "Novel aspects of the Adobe Standard Material").
glm::dvec3 fresnelF82(const glm::dvec3& f0, const glm::dvec3& edgeTint, double cosTheta);

/// Directional albedo of the single-scatter GGX lobe over mu = cos(theta_o), as weights of the reflectance:
/// albedo(Schlick) = F0 * (white - grazing) + F90 * grazing. `exactOutside/Inside` = with the exact
/// reflectance of an index `ior`, seen from the air or from within; `passedOutside/Inside` = what is
/// refracted then, with separable masking.
class AlbedoTable {
 public:
  struct Row {
    double white = 1.0, grazing = 0.0, exactOutside = 0.0, exactInside = 0.0;
    double passedOutside = 1.0, passedInside = 1.0;
  };
  AlbedoTable(double alpha, double ior);
  Row at(double mu) const;
  /// Share of even light that passes the smooth boundary, from the air or from within.
  double meanPassed(bool fromAir) const { return fromAir ? meanFromAir_ : meanFromAir_ / (ior_ * ior_); }

 private:
  Row integrate(double mu) const;
  double alpha_, ior_, meanFromAir_ = 0.0;
  std::vector<Row> rows_;  // at mu = (i / last)^2; empty for a mirror, whose rows are closed forms
};

}  // namespace steradian::oracle
