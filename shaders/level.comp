#version 460
// SPDX-License-Identifier: MIT
// Film -> fourth root of each pixel's light, of which meter.comp takes the mean around a pixel; w = 1.
#extension GL_GOOGLE_include_directive : require
#include "gpu_types.h"
#include "film.glsl"
#include "relative_error.glsl"

layout(local_size_x = METER_GROUP) in;
layout(set = 0, binding = 4) buffer Levels { vec4 levelRoots[]; };
layout(push_constant) uniform Push { FilmParams params; };

void main() {
  uint columns = (params.width + METER_GROUP - 1u) / METER_GROUP;
  uint x = (gl_WorkGroupID.x % columns) * METER_GROUP + gl_LocalInvocationID.x;
  uint begin = (gl_WorkGroupID.x / columns) * METER_PIXELS;
  uint end = x < params.width ? min(begin + METER_PIXELS, params.height) : begin;
  for (uint y = begin; y < end; ++y) {
    uint at = y * params.width + x;
    uvec2 n = halfSamples(params, at);
    vec3 mean = (fetchHalfA(params, at).sum + fetchHalfB(params, at).sum) / max(float(n.x + n.y), 1.0);
    levelRoots[at] = vec4(levelRoot(mean), 1.0);
  }
}
