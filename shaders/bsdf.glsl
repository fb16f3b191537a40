// SPDX-License-Identifier: MIT
// Lambert, GGX facets that reflect (dielectric and metal, mixed as glTF 2.0, appendix B) and transmit, and a coat over
// them all, evaluated. Directions in the local frame (+Z the normal on wo's side), pointing away from the surface.
// Binding-free.
#ifndef BSDF_GLSL
#define BSDF_GLSL
#include "microfacet.glsl"

// What one material shows to one direction wo. Start from noLobes().
struct Lobes {
  vec3 diffuse;          // albedo of the Lambert lobe
  float dielectricF0;    // which loses this Schlick reflectance at the half vector
  float dielectricF90;
  float exactLoss;       // and this share of the exact one
  float diffusePassed;   // behind glass: 1 / the share of even light that passes from outside; 0 = nothing to pass
  vec3 f0;               // facets: Schlick reflectance head-on, and at grazing
  vec3 f90;
  vec3 edge;             // less edge * cos * (1 - cos)^6 (F82)
  float exact;           // plus this share of the exact dielectric reflectance
  float alpha;           // roughness^2
  vec3 transmit;         // tint of what passes these facets
  float eta;             // n(other side) / n(wo's side)
  bool thin;             // sheet: passes without bending
  float coat;            // weight of a coat of F0 = 0.04
  float coatAlpha;
  float chance;          // to sample the facets,
  float coatChance;      // the coat; the diffuse lobe has the rest
};

Lobes noLobes() {
  Lobes lobes;
  lobes.diffuse = vec3(0.0);
  lobes.dielectricF0 = 0.0;
  lobes.dielectricF90 = 0.0;
  lobes.exactLoss = 0.0;
  lobes.diffusePassed = 0.0;
  lobes.f0 = vec3(0.0);
  lobes.f90 = vec3(0.0);
  lobes.edge = vec3(0.0);
  lobes.exact = 0.0;
  lobes.alpha = 1.0;
  lobes.transmit = vec3(0.0);
  lobes.eta = 1.5;
  lobes.thin = false;
  lobes.coat = 0.0;
  lobes.coatAlpha = 1.0;
  lobes.chance = 0.0;
  lobes.coatChance = 0.0;
  return lobes;
}

// Which lobes a variant knows; the others are compiled out.
struct LobeKinds {
  bool diffuse;
  bool glossy;
  bool mirror;
  bool transmission;
  bool coat;
  bool edgeTint;
  bool allNormals;  // a measurement: facets are drawn by their distribution alone
};

// f(wo, wi) * |cos wi| and the solid-angle pdf of sampling wi, without the lobes of zero width.
struct BsdfValue {
  vec3 fCos;
  float pdf;
};

const float COAT_F0 = 0.04;
float coatReflectance(float weight, float grazing) { return weight * (COAT_F0 + (1.0 - COAT_F0) * grazing); }

// Exact reflectance of the surface or sheet by the cosine to the facet.
float glassReflectance(Lobes lobes, float cosine) {
  float r = fresnelDielectric(cosine, lobes.eta);
  return lobes.thin ? sheetReflectance(r) : r;
}

// Reflectance of the facets; glass = glassReflectance.
vec3 facetReflectance(Lobes lobes, float cosine, float grazing, float glass, LobeKinds kinds) {
  vec3 f = fresnelSchlick(lobes.f0, lobes.f90, grazing);
  // Kutz, Hasan & Edmondson 2021, kept from turning negative beside a dark edge.
  if (kinds.edgeTint) f = max(f - lobes.edge * (cosine * (1.0 - cosine) * grazing), vec3(0.0));
  if (kinds.transmission) f += vec3(lobes.exact * glass);
  return f;
}

// A straight or refracted beam instead of a lobe: smooth glass, or refraction too weak to widen it.
bool passesUnscattered(Lobes lobes) {
  return lobes.alpha < MIRROR_ALPHA || (!lobes.thin && lobes.alpha * abs(lobes.eta - 1.0) < 1e-5);
}

// Chance of a sampled facet to let light pass instead of mirroring it: its own share, so that weights stay near 1 however
// often light goes round in rough glass (Walter et al. 2007, 5.3). Beams are chosen by the mean facet, as they have no
// other. cosine and passing: to the facet, and 1 - glassReflectance there.
float passedShare(Lobes lobes, float cosO, float cosine, float passing, LobeKinds kinds) {
  bool beam = passesUnscattered(lobes);
  float met = beam ? cosO : cosine;
  float passes = beam ? 1.0 - glassReflectance(lobes, cosO) : passing;
  float mirrored = luminance(facetReflectance(lobes, met, pow5(1.0 - met), 1.0 - passes, kinds));
  float passed = luminance(lobes.transmit) * passes;
  return passed > 0.0 ? passed / (passed + mirrored) : 0.0;
}

float diffuseChance(Lobes lobes, LobeKinds kinds) {
  float rest = 1.0 - lobes.chance;
  if (kinds.coat) rest -= lobes.coatChance;
  return max(rest, 0.0);
}

// The sine squared up to which light that is diffuse behind glass leaves: from within, not where total reflection begins.
float diffuseRange(Lobes lobes, LobeKinds kinds) {
  bool narrow = kinds.transmission && lobes.diffusePassed > 0.0;
  return narrow ? min(lobes.eta * lobes.eta, 1.0) : 1.0;
}

// The diffuse lobe, white. Behind glass its light has to pass the surface once more, as light from wo had to: the lobe is
// reciprocal then, and sends nothing where a smooth solid would keep it for ever.
FacetValue diffuseValue(Lobes lobes, float cosI, LobeKinds kinds) {
  float lambert = cosI * (1.0 / PI);
  float leaving = 1.0;
  if (kinds.transmission) {
    float range = diffuseRange(lobes, kinds);
    float sin2 = 1.0 - cosI * cosI;
    float cosT = sqrt(max(1.0 - sin2 / (lobes.eta * lobes.eta), 0.0));
    float passed = fresnelTransmitted(cosI, cosT, lobes.eta) * lobes.diffusePassed;
    leaving = lobes.diffusePassed > 0.0 ? passed : 1.0;
    lambert = sin2 <= range ? lambert / range : 0.0;
  }
  return FacetValue(lambert * leaving, lambert);
}

BsdfValue transmittedValue(Lobes lobes, vec3 wo, vec3 wi, LobeKinds kinds) {
  vec3 h = lobes.thin ? vec3(wo.x + wi.x, wo.y + wi.y, wo.z - wi.z) : wo + wi * lobes.eta;
  float length2 = max(dot(h, h), 1e-30);
  FacetValue solid = refractingFacets(h, length2, wo, wi, lobes.eta, lobes.alpha);
  FacetValue sheet = reflectingFacets(h, length2, wo.z, -wi.z, lobes.alpha);
  float fCos = lobes.thin ? sheet.fCos : solid.fCos;
  if (kinds.allNormals) {
    sheet.pdf = reflectingDensityOfAll(h, length2, lobes.alpha);
    solid.pdf = refractingDensityOfAll(h, length2, wi, lobes.eta, lobes.alpha);
  }
  float pdf = lobes.thin ? sheet.pdf : solid.pdf;
  float inverse = inversesqrt(length2);
  float cosO = min(abs(dot(wo, h)) * inverse, 1.0);
  float cosT = abs(dot(wi, h)) * inverse;
  if (lobes.thin) cosT = sqrt(max(1.0 - (1.0 - cosO * cosO) / (lobes.eta * lobes.eta), 0.0));
  float through = fresnelTransmitted(cosO, cosT, lobes.eta);
  if (lobes.thin) through /= 2.0 - through;  // 1 - sheetReflectance
  bool beam = passesUnscattered(lobes);
  vec3 passed = lobes.transmit * (through * fCos);
  float chance = lobes.chance * passedShare(lobes, wo.z, cosO, through, kinds);
  return BsdfValue(beam ? vec3(0.0) : passed, beam ? 0.0 : chance * pdf);
}

// wo above the horizon; wi below it is transmission.
BsdfValue evalBsdf(Lobes lobes, vec3 wo, vec3 wi, LobeKinds kinds) {
  vec3 h = wo + wi;
  float length2 = dot(h, h);
  float cosH = min(0.5 * sqrt(length2), 1.0);  // wo.h = (1 + wo.wi) / |wo + wi|; above 1, Fresnel would turn negative
  float grazing = pow5(1.0 - cosH);
  float glass = kinds.transmission ? glassReflectance(lobes, cosH) : 0.0;
  vec3 fCos = vec3(0.0);
  float pdf = 0.0;
  if (kinds.diffuse) {
    float loss = lobes.dielectricF0 + (lobes.dielectricF90 - lobes.dielectricF0) * grazing;
    if (kinds.transmission) loss += lobes.exactLoss * glass;
    FacetValue diffuse = diffuseValue(lobes, wi.z, kinds);
    fCos = lobes.diffuse * ((1.0 - loss) * diffuse.fCos);
    pdf = diffuseChance(lobes, kinds) * diffuse.pdf;
  }
  if (kinds.glossy) {
    FacetValue facets = reflectingFacets(h, length2, wo.z, wi.z, lobes.alpha);
    if (kinds.allNormals) facets.pdf = reflectingDensityOfAll(h, length2, lobes.alpha);
    fCos += facetReflectance(lobes, cosH, grazing, glass, kinds) * facets.fCos;
    float chance = lobes.chance;
    if (kinds.transmission) chance *= 1.0 - passedShare(lobes, wo.z, cosH, 1.0 - glass, kinds);
    pdf += chance * facets.pdf;
  }
  if (kinds.coat) {
    FacetValue facets = reflectingFacets(h, length2, wo.z, wi.z, lobes.coatAlpha);
    if (kinds.allNormals) facets.pdf = reflectingDensityOfAll(h, length2, lobes.coatAlpha);
    fCos += vec3(coatReflectance(lobes.coat, grazing) * facets.fCos);
    pdf += lobes.coatChance * facets.pdf;
  }
  bool above = wo.z > 0.0 && wi.z > 0.0;
  BsdfValue value = BsdfValue(above ? fCos : vec3(0.0), above ? pdf : 0.0);
  if (kinds.transmission && kinds.glossy) {
    BsdfValue passed = transmittedValue(lobes, wo, wi, kinds);
    bool below = wo.z > 0.0 && wi.z < 0.0;
    value.fCos = below ? passed.fCos : value.fCos;
    value.pdf = below ? passed.pdf : value.pdf;
  }
  return value;
}

#endif
