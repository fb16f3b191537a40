// SPDX-License-Identifier: MIT
// The material as a function: values for pairs of directions, and the directions of its perfect mirrors.
#pragma once
#include <vector>

#include "tests/oracle/world.hpp"

namespace steradian::oracle {

/// What a direction of zero width carries: outgoing radiance = energy * compression * radiance from wi.
struct DeltaLobe {
  dvec3 wi{0.0}, energy{0.0};
  double compression = 1.0;  // square of the relative index across a refraction
};

/// The scattering of one finish seen from `wo`, in a frame whose z is the normal on wo's side (wo.z > 0).
///
/// glTF 2.0 appendix B with KHR_materials_specular, metallic mixing a dielectric and a metal. With albedo
/// tables the lobes are multiplied by 1 + F0 (1 - E) / E (Turquin 2019), and what lies below a lobe loses its
/// albedo at wo; without them it loses the reflectance at the half vector (coat: at the normal). Choices made
/// here: glass (transmission > 0) reflects by the exact Fresnel law and ignores the specular weight; with
/// tables its two lobes are divided by their common albedo at wo; every crossing of a tinted surface costs
/// one albedo; with tables, the matt lobe of a solid that also passes light lies behind its smooth boundary,
/// which light crosses on both ways: (1 - F(wo)) (1 - F(wi)) over the mean of 1 - F; thin glass is a pane of
/// two faces, whose inner reflections are summed; it passes straight on, and when rough scatters what passes
/// as a reflection would be, mirrored through the sheet (KHR_materials_transmission).
class Bsdf {
 public:
  /// `outside`: wo is on the side of the outward normal; `solid`: the surface bounds a volume.
  Bsdf(const Finish& finish, const dvec3& wo, bool outside, bool solid);

  /// 1/sr, without the cosine and without the delta lobes. wi.z < 0 is transmission.
  dvec3 evaluate(const dvec3& wi) const;
  std::vector<DeltaLobe> deltas() const;

  bool scatters() const;         // evaluate() is not 0 everywhere
  bool scattersThrough() const;  // ... not even below

 private:
  dvec3 reflect(const dvec3& wi) const;
  dvec3 transmit(const dvec3& wi) const;
  DeltaLobe straightOrRefracted() const;
  double dielectric(double c) const;
  dvec3 metal(double c) const;
  double diffuseShare(double c) const;
  double diffuseShape(double cosI) const;
  double belowCoat() const;
  double compensation(double f0, const AlbedoTable* table) const;
  double specularGain() const;

  const Finish& finish_;
  const Material& m_;
  dvec3 wo_, albedo_;
  double alpha_, coatAlpha_, f0_, etaO_, etaT_;
  bool outside_, solid_;
};

}  // namespace steradian::oracle
