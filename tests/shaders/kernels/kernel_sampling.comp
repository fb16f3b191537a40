#version 460
// SPDX-License-Identifier: MIT
// sampling.glsl: warps of the unit square, fed with independent numbers so that histograms may be compared.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "bsdf.glsl"
#include "random.glsl"
#include "sampling.glsl"

void main() {
  uint at = invocation();
  float u = sampleIndependent(0x51ed270bu, at, 0u);
  float v = sampleIndependent(0x51ed270bu, at, 1u);
  float c = cos(2.0 * PI * v);
  float s = sin(2.0 * PI * v);
  if (kOperation == 0u) {
    vec4 q = questions[at];
    answers[at] = vec4(powerHeuristic(q.x, q.y), powerHeuristic(q.y, q.x), 0.0, 0.0);
  } else if (kOperation == 1u) {
    answers[at] = vec4(cosineHemisphere(c, s, u), 0.0);
  } else {
    vec4 q = questions[0];  // outgoing direction, alpha
    answers[at] = vec4(normalize(visibleNormal(q.xyz, q.w, ggxA(q.z, q.w), c, s, u)), 0.0);
  }
}
