// SPDX-License-Identifier: MIT
#include "tests/oracle/bsdf.hpp"

#include <cmath>
#include <numbers>

namespace steradian::oracle {
namespace {

constexpr double kCoatF0 = 0.04;  // index 1.5

double schlick(double f0, double f90, double c) {
  return f0 + (f90 - f0) * schlickWeight(c);
}
/// The lobe without its reflectance: D G2 / (4 cos cos).
double microfacets(double alpha, const dvec3& wo, const dvec3& wi, const dvec3& h) {
  if (alpha < kMirrorAlpha) return 0.0;
  return ggxD(alpha, h.z) * smithG2(alpha, wo.z, wi.z) / (4.0 * wo.z * wi.z);
}

}  // namespace

Bsdf::Bsdf(const Finish& finish, const dvec3& wo, bool outside, bool solid)
    : finish_(finish), m_(finish.material), wo_(wo), albedo_(m_.albedo), outside_(outside), solid_(solid) {
  const double r = m_.roughness, coat = m_.clearcoatRoughness, n = m_.ior;
  alpha_ = r * r;
  coatAlpha_ = coat * coat;
  f0_ = (n - 1.0) / (n + 1.0) * ((n - 1.0) / (n + 1.0));
  if (m_.transmission == 0.0f) f0_ *= m_.specular;
  const bool within = solid && !outside;
  etaO_ = within ? n : 1.0;
  etaT_ = within ? 1.0 : n;
}

bool Bsdf::scatters() const {
  const bool matt = m_.metallic < 1.0f && m_.transmission < 1.0f;
  return matt || alpha_ >= kMirrorAlpha || (m_.clearcoat > 0.0f && coatAlpha_ >= kMirrorAlpha);
}
bool Bsdf::scattersThrough() const {
  return m_.transmission > 0.0f && m_.metallic < 1.0f && alpha_ >= kMirrorAlpha && etaO_ != etaT_;
}

double Bsdf::dielectric(double c) const {
  if (m_.transmission == 0.0f) return schlick(f0_, m_.specular, c);
  const double F = fresnelDielectric(c, etaO_, etaT_);
  return solid_ ? F : 2.0 * F / (1.0 + F);  // a pane's two faces: F + (1 - F)^2 F (1 + F^2 + F^4 + ...)
}
dvec3 Bsdf::metal(double c) const {
  return fresnelF82(albedo_, dvec3(m_.edgeTint), c);
}

double Bsdf::compensation(double f0, const AlbedoTable* table) const {
  if (!table) return 1.0;
  const double E = table->at(wo_.z).white;
  return 1.0 + f0 * (1.0 - E) / E;
}

double Bsdf::specularGain() const {
  const AlbedoTable* table = finish_.base.get();
  if (!table || m_.transmission == 0.0f) return compensation(f0_, table);
  const AlbedoTable::Row row = table->at(wo_.z);
  if (!solid_) return 1.0 / row.white;
  return 1.0 / (etaO_ < etaT_ ? row.exactOutside + row.passedOutside : row.exactInside + row.passedInside);
}

double Bsdf::diffuseShare(double c) const {
  if (!finish_.base) return 1.0 - dielectric(c);
  const AlbedoTable::Row row = finish_.base->at(wo_.z);
  const double schlickAlbedo = f0_ * (row.white - row.grazing) + m_.specular * row.grazing;
  const double exactAlbedo = etaO_ < etaT_ ? row.exactOutside : row.exactInside;
  return 1.0 - (m_.transmission > 0.0f ? exactAlbedo : schlickAlbedo) * specularGain();
}

double Bsdf::diffuseShape(double cosI) const {
  if (!finish_.base || m_.transmission == 0.0f || !solid_) return 1.0;
  return (1.0 - fresnelDielectric(cosI, etaO_, etaT_)) / finish_.base->meanPassed(etaO_ < etaT_);
}

double Bsdf::belowCoat() const {
  if (m_.clearcoat == 0.0f) return 1.0;
  if (!finish_.coat) return 1.0 - m_.clearcoat * schlick(kCoatF0, 1.0, wo_.z);
  const AlbedoTable::Row row = finish_.coat->at(wo_.z);
  const double albedo = kCoatF0 * (row.white - row.grazing) + row.grazing;
  return 1.0 - m_.clearcoat * albedo * compensation(kCoatF0, finish_.coat.get());
}

dvec3 Bsdf::evaluate(const dvec3& wi) const {
  return wi.z > 0.0 ? reflect(wi) : wi.z < 0.0 && scattersThrough() ? transmit(wi) : dvec3(0.0);
}

dvec3 Bsdf::reflect(const dvec3& wi) const {
  const dvec3 h = glm::normalize(wo_ + wi);
  const double c = glm::dot(wo_, h);
  const double lobe = microfacets(alpha_, wo_, wi, h);
  const AlbedoTable* table = finish_.base.get();
  const double matt = (1.0 - m_.transmission) * diffuseShare(c) * diffuseShape(wi.z);
  const dvec3 diffuse = albedo_ * (matt / std::numbers::pi);
  const dvec3 plastic = diffuse + lobe * dielectric(c) * specularGain();
  dvec3 metallic = lobe * metal(c);
  for (int i = 0; i < 3; ++i) metallic[i] *= compensation(albedo_[i], table);
  const double coat = microfacets(coatAlpha_, wo_, wi, h) * schlick(kCoatF0, 1.0, c) *
                      compensation(kCoatF0, finish_.coat.get());
  return belowCoat() * glm::mix(plastic, metallic, double(m_.metallic)) + m_.clearcoat * coat;
}

// Walter et al. 2007, eqs. 16 and 21: i = where the light comes from, o = the eye; separable Smith terms.
dvec3 Bsdf::transmit(const dvec3& wi) const {
  const dvec3 tint = albedo_ * (belowCoat() * m_.transmission * (1.0 - m_.metallic) * specularGain());
  if (!solid_) {
    const dvec3 mirrored(wi.x, wi.y, -wi.z), h = glm::normalize(wo_ + mirrored);
    return tint * (microfacets(alpha_, wo_, mirrored, h) * (1.0 - dielectric(glm::dot(wo_, h))));
  }
  dvec3 h = glm::normalize(etaO_ * wo_ + etaT_ * wi);
  if (h.z < 0.0) h = -h;
  const double oh = glm::dot(wo_, h), ih = glm::dot(wi, h);
  if (oh <= 0.0 || ih >= 0.0) return dvec3(0.0);
  const double G = 1.0 / ((1.0 + smithLambda(alpha_, wo_.z)) * (1.0 + smithLambda(alpha_, -wi.z)));
  const double jacobian = etaO_ * etaO_ / std::pow(etaT_ * ih + etaO_ * oh, 2.0);
  const double value = oh * -ih / (wo_.z * -wi.z) * jacobian * (1.0 - dielectric(oh)) * G * ggxD(alpha_, h.z);
  return tint * value;
}

DeltaLobe Bsdf::straightOrRefracted() const {
  const dvec3 energy =
      albedo_ * (belowCoat() * m_.transmission * (1.0 - m_.metallic) * (1.0 - dielectric(wo_.z)));
  const double eta = solid_ ? etaO_ / etaT_ : 1.0;
  const double sinT2 = eta * eta * (1.0 - wo_.z * wo_.z);
  if (sinT2 >= 1.0) return {dvec3(0.0, 0.0, -1.0), dvec3(0.0)};
  const dvec3 wi(-eta * wo_.x, -eta * wo_.y, -std::sqrt(1.0 - sinT2));
  return {glm::normalize(wi), energy, eta * eta};
}

std::vector<DeltaLobe> Bsdf::deltas() const {
  std::vector<DeltaLobe> lobes;
  dvec3 mirror(0.0);
  if (alpha_ < kMirrorAlpha)
    mirror += belowCoat() * glm::mix(dvec3(dielectric(wo_.z)), metal(wo_.z), double(m_.metallic));
  if (coatAlpha_ < kMirrorAlpha) mirror += m_.clearcoat * schlick(kCoatF0, 1.0, wo_.z);
  if (mirror != dvec3(0.0)) lobes.push_back({{-wo_.x, -wo_.y, wo_.z}, mirror});
  if (m_.transmission > 0.0f && m_.metallic < 1.0f && !scattersThrough())
    lobes.push_back(straightOrRefracted());
  return lobes;
}

}  // namespace steradian::oracle
