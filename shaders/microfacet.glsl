// SPDX-License-Identifier: MIT
// Fresnel's reflectance, and GGX facets with height-correlated Smith masking. Binding-free.
#ifndef MICROFACET_GLSL
#define MICROFACET_GLSL
#include "numerics.glsl"

// Below this alpha the lobe is a perfect mirror: D would exceed what float can weigh.
const float MIRROR_ALPHA = 1e-3;

float pow5(float x) {
  float x2 = x * x;
  return x2 * x2 * x;
}

// Schlick 1994 between f0 and f90; grazing = (1 - cosine to the half vector)^5.
vec3 fresnelSchlick(vec3 f0, vec3 f90, float grazing) { return f0 + (f90 - f0) * grazing; }

// Exact unpolarized dielectric reflectance; eta = n(transmitted side) / n(incident side).
float fresnelDielectric(float cosine, float eta) {
  float sin2 = (1.0 - cosine * cosine) / (eta * eta);
  if (sin2 >= 1.0) return 1.0;
  float cosT = sqrt(1.0 - sin2);
  float parallel = eta * cosine + cosT;
  float perpendicular = cosine + eta * cosT;
  float inverse = 1.0 / (parallel * perpendicular);
  float p = (eta * cosine - cosT) * perpendicular * inverse;
  float s = (cosine - eta * cosT) * parallel * inverse;
  return 0.5 * (p * p + s * s);
}

// What passes, 1 - fresnelDielectric, by the cosines on both sides: the same for light that comes back this way, and
// with all its digits where little passes, at grazing angles and near total reflection.
float fresnelTransmitted(float cosO, float cosT, float eta) {
  float s = cosO + eta * cosT;
  float p = eta * cosO + cosT;
  float inverse = 1.0 / max(s * p, 1e-18);
  return 2.0 * eta * cosO * cosT * (s * s + p * p) * (inverse * inverse);
}

// A thin sheet reflects at both faces, with all reflections between them: R + T^2 R / (1 - R^2) for T = 1 - R.
float sheetReflectance(float r) { return 2.0 * r / (1.0 + r); }

// GGX distribution (Walter et al. 2007) in the local-frame form that keeps its digits at low alpha.
// h need not have unit length; length2 = dot(h, h).
float ggxD(vec3 h, float length2, float alpha) {
  float x = alpha * length2 / (h.x * h.x + h.y * h.y + alpha * alpha * h.z * h.z);
  return x * x * (1.0 / PI);
}

// sqrt(alpha^2 + (1 - alpha^2) cos^2): with it Smith's Lambda = (ggxA / cos - 1) / 2 (Heitz, JCGT 3(2), 2014).
float ggxA(float cosine, float alpha) {
  float a2 = alpha * alpha;
  return sqrt(a2 + (1.0 - a2) * cosine * cosine);
}

// Smith masking of one direction.
float smithG1(float cosine, float alpha) { return 2.0 * cosine / (cosine + ggxA(cosine, alpha)); }

// Height-correlated masking and shadowing of both directions.
float smithG2(float cosO, float cosI, float alpha) {
  return 2.0 * cosO * cosI / (cosI * ggxA(cosO, alpha) + cosO * ggxA(cosI, alpha));
}

// White facets, or what lies below them: value times cosine, and density of sampling, per solid angle.
struct FacetValue {
  float fCos;
  float pdf;
};

// Facets that mirror wo to wi, with h = wo + wi and both cosines > 0: D G2 / (4 cosO cosI) cosI as one bounded term,
// over one common denominator. The density of a mirror lobe is 0.
FacetValue reflectingFacets(vec3 h, float length2, float cosO, float cosI, float alpha) {
  float a = max(alpha, MIRROR_ALPHA);
  float aO = ggxA(cosO, a);
  float spread = h.x * h.x + h.y * h.y + a * a * h.z * h.z;
  float masking = cosI * aO + cosO * ggxA(cosI, a);
  float inverse = 1.0 / (spread * masking);
  float x = a * length2 * (masking * inverse);
  float d = x * x * (alpha >= MIRROR_ALPHA ? 0.5 / PI : 0.0);
  return FacetValue(d * cosI * (spread * inverse), d / (cosO + aO));
}

// The density if facets are drawn whether wo sees them or not: D cos / (4 wo.h) (Walter et al. 2007, eq. 14 and 24).
float reflectingDensityOfAll(vec3 h, float length2, float alpha) {
  float d = ggxD(h, length2, max(alpha, MIRROR_ALPHA));
  return alpha >= MIRROR_ALPHA ? d * max(h.z, 0.0) / (2.0 * length2) : 0.0;
}

// The same for refraction (eq. 17 and 24), h = wo + eta wi.
float refractingDensityOfAll(vec3 h, float length2, vec3 wi, float eta, float alpha) {
  float cosIH = abs(dot(wi, h));
  return alpha >= MIRROR_ALPHA ? ggxD(h, length2, alpha) * abs(h.z) * cosIH * eta * eta / (length2 * length2) : 0.0;
}

// Facets that refract wo to wi, with cosI < 0 and h = wo + eta wi (Walter et al. 2007, eq. 16, 17 and 21), G separable
// as there. Radiance that comes from a medium of index eta has been compressed by eta^2.
FacetValue refractingFacets(vec3 h, float length2, vec3 wo, vec3 wi, float eta, float alpha) {
  float side = h.z < 0.0 ? -1.0 : 1.0;
  float inverse = side * inversesqrt(length2);
  float cosOH = dot(wo, h) * inverse;
  float cosIH = -dot(wi, h) * inverse;
  float aO = ggxA(wo.z, alpha);
  // D G1(wo) (wo.h) / wo.z * |wi.h| / |wo + eta wi|^2
  float visible = ggxD(h, length2, alpha) * 2.0 * cosOH * cosIH / ((wo.z + aO) * length2);
  bool through = cosOH > 0.0 && cosIH > 0.0 && alpha >= MIRROR_ALPHA;
  return FacetValue(through ? visible * smithG1(-wi.z, alpha) : 0.0, through ? visible * eta * eta : 0.0);
}

#endif
