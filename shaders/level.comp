#version 460
// SPDX-License-Identifier: MIT
// Film -> fourth root of each pixel's light, of which meter.comp takes the mean around a pixel.
#extension GL_GOOGLE_include_directive : require
#include "gpu_types.h"
#include "film.glsl"
#include "relative_error.glsl"

layout(local_size_x = METER_GROUP) in;
layout(set = 0, binding = 4) buffer Levels { vec4 levelRoots[]; };
layout(push_constant) uniform Push { FilmParams params; };

void main() {
  uint pixels = params.width * params.height;
  uint first = gl_WorkGroupID.x * (METER_GROUP * METER_PIXELS) + gl_LocalInvocationID.x;
  for (uint i = 0u; i < METER_PIXELS; ++i) {
    uint at = first + i * METER_GROUP;
    if (at < pixels) {
      uvec2 n = halfSamples(params, at);
      vec3 mean = (fetchHalfA(params, at).sum + fetchHalfB(params, at).sum) / max(float(n.x + n.y), 1.0);
      levelRoots[at] = vec4(levelRoot(mean), 0.0);
    }
  }
}
