#version 460
// SPDX-License-Identifier: MIT
// bsdf.glsl: lobes evaluated and sampled.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "bsdf_sampling.glsl"
#include "random.glsl"

const LobeKinds kFacets = LobeKinds(false, true, false, false, false, false, false);
Lobes whiteFacets(float alpha) {
  Lobes lobes = noLobes();
  lobes.f0 = vec3(1.0);
  lobes.f90 = vec3(1.0);
  lobes.alpha = alpha;
  lobes.chance = 1.0;
  return lobes;
}

const uint kRows = 9u;
// Rows: (wo, alpha) (wi or u v w, chance) (diffuse, dielectric f0) (f0, dielectric f90) (f90, lobe bits)
//       (edge, exact) (transmit, eta) (coat, coat alpha, coat chance, -) (thin, exact loss, diffuse passed, -).
struct Question {
  Lobes lobes;
  vec3 wo;
  vec3 second;
  LobeKinds kinds;
};

Question fetchQuestion(uint at) {
  vec4 rows[kRows];
  for (uint i = 0u; i < kRows; ++i) rows[i] = questions[kRows * at + i];
  Lobes lobes;
  lobes.alpha = rows[0].w;
  lobes.chance = rows[1].w;
  lobes.diffuse = rows[2].xyz;
  lobes.dielectricF0 = rows[2].w;
  lobes.f0 = rows[3].xyz;
  lobes.dielectricF90 = rows[3].w;
  lobes.f90 = rows[4].xyz;
  lobes.edge = rows[5].xyz;
  lobes.exact = rows[5].w;
  lobes.transmit = rows[6].xyz;
  lobes.eta = rows[6].w;
  lobes.coat = rows[7].x;
  lobes.coatAlpha = rows[7].y;
  lobes.coatChance = rows[7].z;
  lobes.thin = rows[8].x != 0.0;
  lobes.exactLoss = rows[8].y;
  lobes.diffusePassed = rows[8].z;
  uint bits = uint(rows[4].w);
  LobeKinds kinds = LobeKinds((bits & 1u) != 0u, (bits & 2u) != 0u, (bits & 4u) != 0u, (bits & 8u) != 0u,
                              (bits & 16u) != 0u, (bits & 32u) != 0u, false);
  return Question(lobes, rows[0].xyz, rows[1].xyz, kinds);
}

void answerSample(uint at, Question q, vec3 numbers) {
  BsdfSample s = sampleBsdf(q.lobes, q.wo, numbers.x, numbers.y, numbers.z, q.kinds);
  BsdfValue value = evalBsdf(q.lobes, q.wo, s.wi, q.kinds);
  answers[3u * at] = vec4(s.wi, 0.0);
  answers[3u * at + 1u] = vec4(s.weight, 0.0);
  answers[3u * at + 2u] = vec4(value.fCos, value.pdf);
}

void main() {
  uint at = invocation();
  if (kOperation == 0u) {
    Question q = fetchQuestion(at);
    BsdfValue value = evalBsdf(q.lobes, q.wo, q.second, q.kinds);
    answers[at] = vec4(value.fCos, value.pdf);
  } else if (kOperation == 1u) {
    Question q = fetchQuestion(at);
    answerSample(at, q, q.second);
  } else if (kOperation == 2u) {
    // One material and outgoing direction for all; independent numbers.
    vec3 numbers = vec3(sampleIndependent(0x2545f491u, at, 0u), sampleIndependent(0x2545f491u, at, 1u),
                        sampleIndependent(0x2545f491u, at, 2u));
    answerSample(at, fetchQuestion(0u), numbers);
  } else if (kOperation == 3u) {
    // White mirror facets: (wo, alpha) (wi, -).
    vec4 a = questions[2u * at];
    Lobes lobes = whiteFacets(a.w);
    BsdfValue value = evalBsdf(lobes, a.xyz, questions[2u * at + 1u].xyz, kFacets);
    answers[at] = vec4(value.fCos, value.pdf);
  } else if (kOperation == 4u) {
    // (h, alpha) (cosO, cosI, -, -).
    vec4 a = questions[2u * at];
    vec4 b = questions[2u * at + 1u];
    answers[at] = vec4(ggxD(a.xyz, dot(a.xyz, a.xyz), a.w), smithG1(b.x, a.w), smithG2(b.x, b.y, a.w),
                       ggxA(b.x, a.w));
  } else if (kOperation == 5u) {
    // (cosine, eta, f0, f90).
    vec4 q = questions[at];
    answers[at] = vec4(fresnelDielectric(q.x, q.y), fresnelSchlick(vec3(q.z), vec3(q.w), pow5(1.0 - q.x)).x, pow5(q.x), 0.0);
  } else if (kOperation == 7u) {
    // The same from world directions, as the path tracer has them: (n, alpha) (wo, -) (wi, -).
    vec4 a = questions[3u * at];
    Frame frame = frameAround(a.xyz);
    Lobes lobes = whiteFacets(a.w);
    BsdfValue value = evalBsdf(lobes, toLocal(frame, questions[3u * at + 1u].xyz),
                               toLocal(frame, questions[3u * at + 2u].xyz), kFacets);
    answers[at] = vec4(value.fCos, value.pdf);
  } else {
    Question q = fetchQuestion(at);
    Lobes chosen = withChances(q.lobes, q.wo.z, glassReflectance(q.lobes, q.wo.z), 0.1, q.kinds);
    answers[at] = vec4(chosen.chance, chosen.coatChance, diffuseChance(chosen, q.kinds), 0.0);
  }
}
