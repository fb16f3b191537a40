#version 460
// SPDX-License-Identifier: MIT
// How wrong the picture still is: two half-buffers with independent scrambles differ by their errors. With means a, b
// of nA, nB samples, d^2 = (a - b)^2 nA nB / (nA + nB)^2 estimates the variance of the joint mean.
// Beside it, what the film counts: rays, and how much light all its samples brought.
#extension GL_GOOGLE_include_directive : require
#include "gpu_types.h"
#include "film.glsl"
#include "numerics.glsl"

layout(local_size_x = METER_GROUP) in;
layout(set = 0, binding = 6) buffer Partials { vec4 partials[]; };
layout(push_constant) uniform Push { FilmParams params; };

shared vec4 sums[METER_GROUP];
shared float luminances[METER_GROUP];

void main() {
  uint me = gl_LocalInvocationID.x;
  uint pixels = params.width * params.height;
  vec4 sum = vec4(0.0);
  float light = 0.0;
  for (uint i = 0u; i < METER_PIXELS / METER_GROUP; ++i) {
    uint at = gl_WorkGroupID.x * METER_PIXELS + i * METER_GROUP + me;
    if (at < pixels) {
      uvec2 n = max(halfSamples(params, at), uvec2(1u));
      float nA = float(n.x);
      float nB = float(n.y);
      float share = nA * nB / ((nA + nB) * (nA + nB));
      vec4 a = sumA[at];
      vec4 b = sumB[at];
      vec3 difference = a.xyz / nA - b.xyz / nB;
      vec3 mean = (a.xyz + b.xyz) / (nA + nB);
      vec3 d2 = difference * difference * share;
      vec3 relative = d2 / (mean * mean + params.relativeFloor);
      sum += vec4((d2.x + d2.y + d2.z) / 3.0, (relative.x + relative.y + relative.z) / 3.0, a.w + b.w,
                  carryA[at].w + carryB[at].w);
      light += luminance(a.xyz + b.xyz);
    }
  }
  sums[me] = sum;
  luminances[me] = light;
  for (uint half_ = METER_GROUP / 2u; half_ > 0u; half_ /= 2u) {
    barrier();
    if (me < half_) {
      sums[me] += sums[me + half_];
      luminances[me] += luminances[me + half_];
    }
  }
  if (me == 0u) {
    partials[gl_WorkGroupID.x * METER_ROWS] = sums[0];
    partials[gl_WorkGroupID.x * METER_ROWS + 1u] = vec4(luminances[0], 0.0, 0.0, 0.0);
  }
}
