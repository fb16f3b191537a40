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

// Of level.comp: rgb, and 1 to count it by; 0 outside the film.
vec4 levelAt(int x, int y) {
  ivec2 last = ivec2(params.width, params.height) - 1;
  bool inside = min(x, y) >= 0 && x <= last.x && y <= last.y;
  int at = clamp(y, 0, last.y) * int(params.width) + clamp(x, 0, last.x);
  return levelRoots[at] * (inside ? 1.0 : 0.0);
}

// Three pixels of one row.
struct RowLevels {
  vec4 own;
  vec4 sides;
};
RowLevels rowLevels(int x, int y) { return RowLevels(levelAt(x, y), levelAt(x - 1, y) + levelAt(x + 1, y)); }

// Invocations walk down METER_PIXELS of a column, so that each row around a pixel is read once.
void main() {
  uint columns = (params.width + METER_GROUP - 1u) / METER_GROUP;
  uint x = (gl_WorkGroupID.x % columns) * METER_GROUP + gl_LocalInvocationID.x;
  uint begin = (gl_WorkGroupID.x / columns) * METER_PIXELS;
  uint end = x < params.width ? min(begin + METER_PIXELS, params.height) : begin;
  RowLevels above = rowLevels(int(x), int(begin) - 1);
  RowLevels here = rowLevels(int(x), int(begin));
  vec4 sum = vec4(0.0);
  float light = 0.0;
  for (uint y = begin; y < end; ++y) {
    uint at = y * params.width + x;
    uvec2 n = max(halfSamples(params, at), uvec2(1u));
    float nA = float(n.x);
    float nB = float(n.y);
    float share = nA * nB / ((nA + nB) * (nA + nB));
    FilmHalf a = fetchHalfA(params, at);
    FilmHalf b = fetchHalfB(params, at);
    vec3 difference = a.sum / nA - b.sum / nB;
    vec3 mean = (a.sum + b.sum) / (nA + nB);
    vec3 d2 = difference * difference * share;
    RowLevels below = rowLevels(int(x), int(y) + 1);
    vec4 around = above.own + above.sides + here.sides + below.own + below.sides;
    vec3 level = levelOf(around.w > 0.0 ? around.rgb / around.w : here.own.rgb);
    vec3 relative = relativeSquares(d2, mean, level, params.relativeFloor);
    sum += vec4((d2.x + d2.y + d2.z) / 3.0, (relative.x + relative.y + relative.z) / 3.0,
                a.closestRays + b.closestRays, a.shadowRays + b.shadowRays);
    light += luminance(a.sum + b.sum);
    above = here;
    here = below;
  }
  partials[gl_GlobalInvocationID.x * METER_ROWS] = sum;
  partials[gl_GlobalInvocationID.x * METER_ROWS + 1u] = vec4(light, 0.0, 0.0, 0.0);
}
