// SPDX-License-Identifier: MIT
// Which lobe to sample, and a direction from it. Binding-free.
#ifndef BSDF_SAMPLING_GLSL
#define BSDF_SAMPLING_GLSL
#include "bsdf.glsl"
#include "sampling.glsl"

// Chances by the lobes' share of the reflectance seen from wo, at least `least` where the share is a guess. glass: share of
// what glass gives back that it mirrors.
Lobes withChances(Lobes lobes, float cosO, float glass, float least, LobeKinds kinds) {
  float grazing = pow5(1.0 - cosO);
  float f90 = luminance(lobes.f90);
  float f0 = luminance(lobes.f0);
  float specular = f0 + (f90 - f0) * grazing;  // mix() may be rounded in another way in another variant
  float passed = 0.0;
  if (kinds.transmission) {
    specular += lobes.exact * glass;
    f90 += lobes.exact;
    passed = luminance(lobes.transmit) * (1.0 - glass);
  }
  float diffuse = kinds.diffuse ? luminance(lobes.diffuse) : 0.0;
  float facets = specular + passed;
  float mixed = clamp(facets / (facets + diffuse), least, 1.0 - least);
  lobes.chance = diffuse <= 0.0 ? 1.0 : (f90 <= 0.0 ? 0.0 : mixed);
  if (kinds.coat) {
    float coat = coatReflectance(lobes.coat, grazing);
    float share = coat / max(coat + facets + diffuse, 1e-30);
    lobes.coatChance = coat > 0.0 ? clamp(share, 0.1, 0.9) : 0.0;
    lobes.chance *= 1.0 - lobes.coatChance;
  }
  return lobes;
}

struct BsdfSample {
  vec3 wi;
  vec3 weight;  // f * |cos| / pdf; 0 when the sample fell on the wrong side of the horizon
  float pdf;    // solid angle; 0 for a lobe of zero width
};

// Below the surface along the refraction at a facet h of any length; straight up when it reflects totally.
vec3 refracted(vec3 wo, vec3 h, float eta) {
  vec3 n = h * inversesqrt(dot(h, h));
  float cosO = dot(wo, n);
  float cosT2 = 1.0 - (1.0 - cosO * cosO) / (eta * eta);
  vec3 bent = n * (cosO / eta - sqrt(max(cosT2, 0.0))) - wo * (1.0 / eta);
  return cosT2 > 0.0 ? bent : vec3(0.0, 0.0, 1.0);
}

// The lobe that u falls into, and u stretched over it.
struct LobeChoice {
  bool facets;
  bool coat;
  float u;
};

LobeChoice chooseLobe(Lobes lobes, float u, LobeKinds kinds) {
  bool facets = u < lobes.chance;
  bool coat = false;
  float begin = facets ? 0.0 : lobes.chance;
  float width = facets ? lobes.chance : diffuseChance(lobes, kinds);
  if (kinds.coat) {
    float end = 1.0 - lobes.coatChance;
    coat = !facets && u >= end;
    begin = coat ? end : begin;
    width = coat ? lobes.coatChance : width;
  }
  return LobeChoice(facets, coat, clamp((u - begin) / max(width, 1e-6), 0.0, 0.99999994));
}

// A facet visible from wo, of any length.
vec3 sampleFacet(Lobes lobes, LobeChoice choice, vec3 wo, CosSin azimuth, LobeKinds kinds) {
  float alpha = kinds.coat && choice.coat ? lobes.coatAlpha : lobes.alpha;
  vec3 h = visibleNormal(wo, alpha, ggxA(wo.z, alpha), azimuth.c, azimuth.s, choice.u);
  if (kinds.allNormals) h = anyNormal(alpha, azimuth.c, azimuth.s, choice.u);
  return h;
}

// Whether it lets light pass, by w in [0, 1).
bool facetPasses(Lobes lobes, vec3 wo, vec3 h, float w, LobeKinds kinds) {
  float cosine = min(abs(dot(wo, h)) * inversesqrt(dot(h, h)), 1.0);
  return w < passedShare(lobes, wo.z, cosine, 1.0 - glassReflectance(lobes, cosine), kinds);
}

// Where it sends light.
vec3 facetDirection(Lobes lobes, vec3 wo, vec3 h, bool passes, LobeKinds kinds) {
  vec3 wi = h * (2.0 * dot(wo, h) / dot(h, h)) - wo;
  if (kinds.transmission) {
    vec3 passed = lobes.thin ? vec3(wi.x, wi.y, -wi.z) : refracted(wo, h, lobes.eta);
    // Through a facet that is not seen nothing passes: to the wrong side, where it counts as lost.
    if (kinds.allNormals && dot(wo, h) <= 0.0) passed = vec3(0.0, 0.0, 1.0);
    wi = passes ? passed : wi;
  }
  return wi;
}

// A direction, and the lobe that it was drawn from.
struct BsdfDraw {
  LobeChoice choice;
  bool passed;  // through the facets
  vec3 wi;
};

// Replaces a sample of a lobe of zero width.
BsdfSample sampleBeams(BsdfSample made, Lobes lobes, BsdfDraw drawn, vec3 wo, LobeKinds kinds) {
  float glass = kinds.transmission ? glassReflectance(lobes, wo.z) : 0.0;
  float share = kinds.transmission ? passedShare(lobes, wo.z, wo.z, 1.0 - glass, kinds) : 0.0;
  if (kinds.mirror) {
    bool mirror = drawn.choice.facets && !drawn.passed && lobes.alpha < MIRROR_ALPHA;
    vec3 ideal = facetReflectance(lobes, wo.z, pow5(1.0 - wo.z), glass, kinds) / max(lobes.chance * (1.0 - share), 1e-6);
    made.wi = mirror ? vec3(-wo.x, -wo.y, wo.z) : made.wi;
    made.weight = mirror ? ideal : made.weight;
    made.pdf = mirror ? 0.0 : made.pdf;
  }
  if (kinds.transmission) {
    bool beam = drawn.passed && passesUnscattered(lobes);
    vec3 wi = lobes.thin ? vec3(-wo.x, -wo.y, -wo.z) : refracted(wo, vec3(0.0, 0.0, 1.0), lobes.eta);
    float compressed = lobes.thin ? 1.0 : 1.0 / (lobes.eta * lobes.eta);
    vec3 ideal = lobes.transmit * ((1.0 - glass) * compressed / max(lobes.chance * share, 1e-6));
    made.wi = beam ? wi : made.wi;
    made.weight = beam ? ideal : made.weight;
    made.pdf = beam ? 0.0 : made.pdf;
  }
  return made;
}

// One-sample mixture of cosine and visible-normal sampling; (u, v, w) in [0, 1)^3, u also chooses the lobe, and w what
// facets do that both mirror and let pass.
BsdfDraw drawBsdf(Lobes lobes, vec3 wo, float u, float v, float w, LobeKinds kinds) {
  LobeChoice choice = chooseLobe(lobes, u, kinds);
  CosSin azimuth = cosSinTurn(v);
  vec3 wi = kinds.diffuse ? cosineHemisphere(azimuth.c, azimuth.s, choice.u * diffuseRange(lobes, kinds)) : vec3(0.0, 0.0, 1.0);
  vec3 h = vec3(0.0, 0.0, 1.0);
  bool passed = false;
  if (kinds.glossy || kinds.coat) h = sampleFacet(lobes, choice, wo, azimuth, kinds);
  if (kinds.transmission) passed = choice.facets && facetPasses(lobes, wo, h, w, kinds);
  if (kinds.glossy || kinds.coat) {
    vec3 sent = facetDirection(lobes, wo, h, passed, kinds);
    wi = choice.facets || choice.coat ? sent : wi;
  }
  return BsdfDraw(choice, passed, wi);
}

BsdfSample weighDraw(Lobes lobes, BsdfDraw drawn, vec3 wo, LobeKinds kinds) {
  BsdfValue value = evalBsdf(lobes, wo, drawn.wi, kinds);
  vec3 weight = value.fCos * (value.pdf > 0.0 ? 1.0 / value.pdf : 0.0);
  BsdfSample made = BsdfSample(drawn.wi, weight, value.pdf);
  if (kinds.transmission) {
    // A facet may send light to the side that its lobe does not own.
    bool lost = (drawn.wi.z < 0.0) != drawn.passed;
    made.weight = lost ? vec3(0.0) : made.weight;
    made.pdf = lost ? 0.0 : made.pdf;
  }
  if (kinds.mirror || kinds.transmission) made = sampleBeams(made, lobes, drawn, wo, kinds);
  return made;
}

BsdfSample sampleBsdf(Lobes lobes, vec3 wo, float u, float v, float w, LobeKinds kinds) {
  return weighDraw(lobes, drawBsdf(lobes, wo, u, v, w, kinds), wo, kinds);
}

#endif
