#version 460
// SPDX-License-Identifier: MIT
// One ray per invocation against the whole scene, for measurements and tests: the tracer's own traversal.
#extension GL_GOOGLE_include_directive : require
#include "traverse.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 37) const bool kAnyHit = false;
layout(set = 0, binding = 1) readonly buffer Rays { vec4 rays[]; };  // origin, tMax | direction, -
layout(set = 0, binding = 2) writeonly buffer Hits { vec4 hits[]; };  // t, bits: primitive or NO_PRIMITIVE, triangle row, -

void main() {
  // width: how many rays; height: groups in a row of the dispatch
  uint at = (gl_WorkGroupID.y * params.height + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x;
  if (at >= params.width) return;
  Layout l = primitiveLayout();
  vec4 from = rays[2u * at];
  Ray ray = Ray(from.xyz, rays[2u * at + 1u].xyz, NO_PRIMITIVE, false);
  Hit hit = Hit(from.w, NO_PRIMITIVE, 0u);
  if (kAnyHit) hit.primitive = occluded(ray, unplaced(from.w), NO_PRIMITIVE, l) ? 0u : NO_PRIMITIVE;
  else hit = closestHit(ray, from.w, l);
  hits[at] = vec4(hit.t, uintBitsToFloat(hit.primitive), uintBitsToFloat(hit.triangle), 0.0);
}
