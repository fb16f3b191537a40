#version 460
// SPDX-License-Identifier: MIT
// Records one sample of each pixel of a rectangle: one invocation per pixel, the rectangle's corner at (pickX, pickY).
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 1) in;
layout(set = 0, binding = 7) buffer Record { vec4 recordRows[]; };
#include "path_record.glsl"

void main() {
  loadBakedPrimitives();
  loadBakedLights();
  uint path = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  uint rows = RECORD_HEADER + (lastBounce() + 1u) * RECORD_VERTEX_ROWS;
  recordPath(path * rows, uvec2(params.pickX + gl_WorkGroupID.x, params.pickY + gl_WorkGroupID.y));
}
