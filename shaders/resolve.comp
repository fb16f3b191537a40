#version 460
// SPDX-License-Identifier: MIT
// Film -> mean radiance per pixel, for display and read-back (and handed to the graphics queue family, if separate).
#extension GL_GOOGLE_include_directive : require
#include "gpu_types.h"
#include "film.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 5) buffer Resolved { vec4 resolved[]; };
layout(push_constant) uniform Push { FilmParams params; };

void main() {
  uint at = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x;
  if (at >= params.width * params.height) return;
  uvec2 n = halfSamples(params, at);
  float samples = float(n.x + n.y);
  vec3 mean = (fetchHalfA(params, at).sum + fetchHalfB(params, at).sum) / max(samples, 1.0);
  resolved[at] = vec4(mean, samples);
}
