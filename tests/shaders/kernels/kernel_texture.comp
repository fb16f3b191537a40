#version 460
// SPDX-License-Identifier: MIT
// texture.glsl: lookups and mip levels of the textures whose references are the scene rows.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "texture.glsl"

// 0: (u, v, level, first row of the reference) -> texel; 1: (footprint, uvPerMetre, jitter, row) -> level.
void main() {
  uint at = invocation();
  vec4 q = questions[at];
  TextureRef t = fetchTextureRef(uint(q.w));
  if (kOperation == 0u) answers[at] = lookUp(t, q.x, q.y, uint(q.z));
  else answers[at] = vec4(float(mipLevel(t, q.x, q.y, q.z)), 0.0, 0.0, 0.0);
}
