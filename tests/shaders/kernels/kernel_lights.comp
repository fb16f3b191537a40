#version 460
// SPDX-License-Identifier: MIT
// lights.glsl and light_tree.glsl on light rows.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "light_tree.glsl"
#include "lights.glsl"
#include "random.glsl"

// (wi, distance) (illuminance, pdf) (lightPdf of wi, sunRadiance along wi, primitive).
void answerSample(uint at, LightRows light, vec3 p, float u, float v) {
  LightSample s = sampleLight(light, p, u, v);
  answers[3u * at] = vec4(s.wi, s.distance);
  answers[3u * at + 1u] = vec4(s.illuminance, s.pdf);
  float primitive = s.primitive == NO_PRIMITIVE ? -1.0 : float(s.primitive);
  answers[3u * at + 2u] = vec4(lightPdf(light, p, s.wi), sunRadiance(light, s.wi).x, primitive, 0.0);
}

void main() {
  uint at = invocation();
  if (kOperation == 0u) {
    // (p, light) (u, v, -).
    vec4 q = questions[2u * at];
    vec4 r = questions[2u * at + 1u];
    answerSample(at, fetchLight(uint(q.w)), q.xyz, r.x, r.y);
  } else if (kOperation == 1u) {
    // One shared (p, light), and independent numbers.
    vec4 q = questions[0];
    float u = sampleIndependent(0x2545f491u, at, 0u);
    float v = sampleIndependent(0x2545f491u, at, 1u);
    answerSample(at, fetchLight(uint(q.w)), q.xyz, u, v);
  } else if (kOperation == 2u) {
    // (p, u) -> (light, its probability, the same by its trail, -).
    vec4 q = questions[at];
    LightChoice choice = chooseLight(q.xyz, q.w);
    answers[at] = vec4(float(choice.light), choice.probability, lightChoiceProbability(q.xyz, choice.light), 0.0);
  } else if (kOperation == 3u) {
    // (p, light) -> (probability, -).
    vec4 q = questions[at];
    answers[at] = vec4(lightChoiceProbability(q.xyz, uint(q.w)), 0.0, 0.0, 0.0);
  } else {
    // (p, light) (wi, -) -> (lightPdf, sunRadiance, -).
    vec4 q = questions[2u * at];
    LightRows light = fetchLight(uint(q.w));
    vec3 wi = questions[2u * at + 1u].xyz;
    answers[at] = vec4(lightPdf(light, q.xyz, wi), sunRadiance(light, wi).x, 0.0, 0.0);
  }
}
