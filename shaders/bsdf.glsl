// SPDX-License-Identifier: MIT
// Lambert + GGX with height-correlated Smith masking and Schlick Fresnel, mixed as glTF 2.0 (appendix B) does.
// All directions in the local frame (+Z the normal), pointing away from the surface. Binding-free.
#ifndef BSDF_GLSL
#define BSDF_GLSL
#include "numerics.glsl"
#include "sampling.glsl"

// Below this alpha the lobe is a perfect mirror: D would exceed what float can weigh.
const float MIRROR_ALPHA = 1e-3;

struct Lobes {
  vec3 diffuse;   // albedo * (1 - metallic)
  vec3 f0;        // reflectance head-on, dielectric and metal mixed
  float f90;      // reflectance at grazing
  float dielectricF0;
  float dielectricF90;
  float alpha;    // roughness^2
};

// f(wo, wi) * |cos wi| and the solid-angle pdf of sampling wi, without the mirror lobe.
struct BsdfValue {
  vec3 fCos;
  float pdf;
};

float pow5(float x) {
  float x2 = x * x;
  return x2 * x2 * x;
}

// Schlick 1994 between f0 and f90, by the cosine to the half vector.
vec3 fresnelSchlick(vec3 f0, float f90, float cosine) { return f0 + (vec3(f90) - f0) * pow5(1.0 - cosine); }

// Exact unpolarized dielectric reflectance; eta = n(transmitted side) / n(incident side).
float fresnelDielectric(float cosine, float eta) {
  float sin2 = (1.0 - cosine * cosine) / (eta * eta);
  if (sin2 >= 1.0) return 1.0;
  float cosT = sqrt(1.0 - sin2);
  float parallel = (eta * cosine - cosT) / (eta * cosine + cosT);
  float perpendicular = (cosine - eta * cosT) / (cosine + eta * cosT);
  return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

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

// Chance to sample the specular lobe: its share of the reflectance seen from wo, kept away from 0 and 1.
float specularChance(Lobes lobes, float cosO) {
  float specular = mix(luminance(lobes.f0), lobes.f90, pow5(1.0 - cosO));
  float diffuse = luminance(lobes.diffuse);
  float mixed = clamp(specular / (specular + diffuse), 0.1, 0.9);
  return diffuse <= 0.0 ? 1.0 : (lobes.f90 <= 0.0 ? 0.0 : mixed);
}

vec3 diffuseReflectance(Lobes lobes, float cosH) {
  float f = lobes.dielectricF0 + (lobes.dielectricF90 - lobes.dielectricF0) * pow5(1.0 - cosH);
  return lobes.diffuse * (1.0 - f);
}

// Both directions above the horizon, else 0. `glossy` and `diffuseOn` let unused lobes be compiled out.
BsdfValue evalBsdf(Lobes lobes, vec3 wo, vec3 wi, float chance, bool diffuseOn, bool glossyOn) {
  vec3 h = wo + wi;
  float length2 = dot(h, h);
  float cosH = min(0.5 * sqrt(length2), 1.0);  // wo.h = (1 + wo.wi) / |wo + wi|; above 1, Fresnel would turn negative
  vec3 fCos = vec3(0.0);
  float pdf = 0.0;
  if (diffuseOn) {
    fCos = diffuseReflectance(lobes, cosH) * (wi.z * (1.0 / PI));
    pdf = (1.0 - chance) * wi.z * (1.0 / PI);
  }
  if (glossyOn) {
    // The mirror lobe has no density.
    float d = lobes.alpha >= MIRROR_ALPHA ? ggxD(h, length2, lobes.alpha) : 0.0;
    float aO = ggxA(wo.z, lobes.alpha);
    float aI = ggxA(wi.z, lobes.alpha);
    // D G2 / (4 cosO cosI) * cosI as one bounded term.
    float dv = d * 0.5 * wi.z / (wi.z * aO + wo.z * aI);
    fCos += fresnelSchlick(lobes.f0, lobes.f90, cosH) * dv;
    pdf += chance * d * 0.5 / (wo.z + aO);
  }
  bool above = wo.z > 0.0 && wi.z > 0.0;
  return BsdfValue(above ? fCos : vec3(0.0), above ? pdf : 0.0);
}

struct BsdfSample {
  vec3 wi;
  vec3 weight;  // f * |cos| / pdf; 0 when the sample fell below the horizon
};

// One-sample mixture of cosine and visible-normal sampling; (u, v) in [0, 1)^2, u also chooses the lobe.
BsdfSample sampleBsdf(Lobes lobes, vec3 wo, float u, float v, float chance, bool diffuseOn, bool glossyOn,
                      bool mirrorOn) {
  bool specular = u < chance;
  float w = specular ? u / max(chance, 1e-6) : (u - chance) / max(1.0 - chance, 1e-6);
  CosSin azimuth = cosSinTurn(v);
  vec3 wi = diffuseOn ? cosineHemisphere(azimuth.c, azimuth.s, min(w, 0.99999994)) : vec3(0.0, 0.0, 1.0);
  if (glossyOn) {
    vec3 h = visibleNormal(wo, lobes.alpha, ggxA(wo.z, lobes.alpha), azimuth.c, azimuth.s, w);
    vec3 reflected = h * (2.0 * dot(wo, h) / dot(h, h)) - wo;
    wi = specular ? reflected : wi;
  }
  BsdfValue value = evalBsdf(lobes, wo, wi, chance, diffuseOn, glossyOn);
  vec3 weight = value.fCos * (value.pdf > 0.0 ? 1.0 / value.pdf : 0.0);
  if (mirrorOn) {
    bool mirror = specular && lobes.alpha < MIRROR_ALPHA;
    vec3 ideal = fresnelSchlick(lobes.f0, lobes.f90, wo.z) / max(chance, 1e-6);
    wi = mirror ? vec3(-wo.x, -wo.y, wo.z) : wi;
    weight = mirror ? ideal : weight;
  }
  return BsdfSample(wi, weight);
}

#endif
