#version 460
// SPDX-License-Identifier: MIT
// How wrong the picture still is: two half-buffers with independent scrambles differ by their errors. With means a, b
// of nA, nB samples, d^2 = (a - b)^2 nA nB / (nA + nB)^2 estimates the variance of the joint mean; divided by the light of the pixel (relative_error.glsl), the relative one.
// Beside it, what the film counts: rays, and how much light all its samples brought. Each invocation writes its own sums
// for the host to add in double: where barriers are coroutines (CPU drivers), adding them up here took longer.
#extension GL_GOOGLE_include_directive : require
#include "gpu_types.h"
#include "film.glsl"
#include "numerics.glsl"
#include "relative_error.glsl"

layout(local_size_x = METER_GROUP) in;
layout(set = 0, binding = 4) readonly buffer Levels { vec4 levelRoots[]; };
layout(set = 0, binding = 6) buffer Partials { vec4 partials[]; };
layout(push_constant) uniform Push { FilmParams params; };

// Of the light in the up to 8 pixels around this one, by level.comp.
vec3 levelAround(uint at) {
  ivec2 size = ivec2(params.width, params.height);
  ivec2 pixel = ivec2(at % params.width, at / params.width);
  ivec2 least = max(pixel - 1, ivec2(0));
  ivec2 most = min(pixel + 1, size - 1);
  vec3 sum = vec3(0.0);
  for (int y = least.y; y <= most.y; ++y)
    for (int x = least.x; x <= most.x; ++x) sum += levelRoots[y * size.x + x].rgb;
  ivec2 window = most - least + 1;
  int around = window.x * window.y - 1;
  vec3 own = levelRoots[at].rgb;
  return levelOf(around > 0 ? max(sum - own, vec3(0.0)) / float(around) : own);
}

void main() {
  uint pixels = params.width * params.height;
  uint first = gl_WorkGroupID.x * (METER_GROUP * METER_PIXELS) + gl_LocalInvocationID.x;
  vec4 sum = vec4(0.0);
  float light = 0.0;
  for (uint i = 0u; i < METER_PIXELS; ++i) {
    uint at = first + i * METER_GROUP;
    if (at < pixels) {
      uvec2 n = max(halfSamples(params, at), uvec2(1u));
      float nA = float(n.x);
      float nB = float(n.y);
      float share = nA * nB / ((nA + nB) * (nA + nB));
      FilmHalf a = fetchHalfA(params, at);
      FilmHalf b = fetchHalfB(params, at);
      vec3 difference = a.sum / nA - b.sum / nB;
      vec3 mean = (a.sum + b.sum) / (nA + nB);
      vec3 d2 = difference * difference * share;
      vec3 relative = relativeSquares(d2, mean, levelAround(at), params.relativeFloor);
      sum += vec4((d2.x + d2.y + d2.z) / 3.0, (relative.x + relative.y + relative.z) / 3.0,
                  a.closestRays + b.closestRays, a.shadowRays + b.shadowRays);
      light += luminance(a.sum + b.sum);
    }
  }
  partials[gl_GlobalInvocationID.x * METER_ROWS] = sum;
  partials[gl_GlobalInvocationID.x * METER_ROWS + 1u] = vec4(light, 0.0, 0.0, 0.0);
}
