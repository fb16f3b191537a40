#version 460
// SPDX-License-Identifier: MIT
// bsdf.glsl: lobes evaluated and sampled.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "bsdf.glsl"
#include "random.glsl"

Lobes lobesOf(vec3 diffuse, vec3 f0, float f90, vec2 dielectric, float alpha) {
  Lobes lobes;
  lobes.diffuse = diffuse;
  lobes.f0 = f0;
  lobes.f90 = f90;
  lobes.dielectricF0 = dielectric.x;
  lobes.dielectricF90 = dielectric.y;
  lobes.alpha = alpha;
  return lobes;
}
Lobes whiteFacets(float alpha) { return lobesOf(vec3(0.0), vec3(1.0), 1.0, vec2(0.0), alpha); }

// Rows: (wo, alpha) (wi or u v -, chance) (diffuse, dielectric f0) (f0, dielectric f90) (f90, -, -, lobe bits).
struct Question {
  Lobes lobes;
  vec3 wo;
  vec3 second;
  float chance;
  bool diffuseOn, glossyOn, mirrorOn;
};

Question fetchQuestion(uint first) {
  vec4 a = questions[first];
  vec4 b = questions[first + 1u];
  vec4 c = questions[first + 2u];
  vec4 d = questions[first + 3u];
  vec4 e = questions[first + 4u];
  uint bits = uint(e.w);
  return Question(lobesOf(c.xyz, d.xyz, e.x, vec2(c.w, d.w), a.w), a.xyz, b.xyz, b.w, (bits & 1u) != 0u,
                  (bits & 2u) != 0u, (bits & 4u) != 0u);
}

void answerSample(uint at, Question q, float u, float v) {
  BsdfSample s = sampleBsdf(q.lobes, q.wo, u, v, q.chance, q.diffuseOn, q.glossyOn, q.mirrorOn);
  BsdfValue value = evalBsdf(q.lobes, q.wo, s.wi, q.chance, q.diffuseOn, q.glossyOn);
  answers[3u * at] = vec4(s.wi, 0.0);
  answers[3u * at + 1u] = vec4(s.weight, 0.0);
  answers[3u * at + 2u] = vec4(value.fCos, value.pdf);
}

void main() {
  uint at = invocation();
  if (kOperation == 0u) {
    Question q = fetchQuestion(5u * at);
    BsdfValue value = evalBsdf(q.lobes, q.wo, q.second, q.chance, q.diffuseOn, q.glossyOn);
    answers[at] = vec4(value.fCos, value.pdf);
  } else if (kOperation == 1u) {
    Question q = fetchQuestion(5u * at);
    answerSample(at, q, q.second.x, q.second.y);
  } else if (kOperation == 2u) {
    // One material and outgoing direction for all; independent numbers.
    answerSample(at, fetchQuestion(0u), sampleIndependent(0x2545f491u, at, 0u),
                 sampleIndependent(0x2545f491u, at, 1u));
  } else if (kOperation == 3u) {
    // White mirror facets: (wo, alpha) (wi, -).
    vec4 a = questions[2u * at];
    Lobes lobes = whiteFacets(a.w);
    BsdfValue value = evalBsdf(lobes, a.xyz, questions[2u * at + 1u].xyz, 1.0, false, true);
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
    answers[at] = vec4(fresnelDielectric(q.x, q.y), fresnelSchlick(vec3(q.z), q.w, q.x).x, pow5(q.x), 0.0);
  } else if (kOperation == 7u) {
    // The same from world directions, as the path tracer has them: (n, alpha) (wo, -) (wi, -).
    vec4 a = questions[3u * at];
    Frame frame = frameAround(a.xyz);
    Lobes lobes = whiteFacets(a.w);
    BsdfValue value = evalBsdf(lobes, toLocal(frame, questions[3u * at + 1u].xyz),
                               toLocal(frame, questions[3u * at + 2u].xyz), 1.0, false, true);
    answers[at] = vec4(value.fCos, value.pdf);
  } else {
    Question q = fetchQuestion(5u * at);
    answers[at] = vec4(specularChance(q.lobes, q.wo.z), diffuseReflectance(q.lobes, q.second.z));
  }
}
