// SPDX-License-Identifier: MIT
// Surfaces that are there only in part: each is met or passed as a whole, in proportion to its opacity. Rays that shade
// and rays to lights decide alike, about one nearest surface after the other, so that passing costs no bounce.
#ifndef ALPHA_GLSL
#define ALPHA_GLSL
#include "mesh_attributes.glsl"
#include "random.glsl"
#include "texture.glsl"

// What all decisions of one ray depend on; 0: whatever has any opacity is met. Rays whose results are multiplied need
// different ones.
uint alphaSeed = 0u;

void seedAlpha(uint seed, uint index, uint ray) {
  if (kAlpha) alphaSeed = hashCombine(hashCombine(seed, index), ray) | 1u;
}

// The material's opacity at a point of a triangle. Textures are read in full resolution: samples average them.
float opacityAt(uint materialRow, uint primitive, uint triangle, vec3 weights, Layout l) {
  Corners corners = cornersOf(primitive, triangle, l);
  float opacity = fetchRow(materialRow + 7u).y * interpolatedColor(corners, weights).w;
  uint ref = floatBitsToUint(fetchRow(materialRow + 6u).x);
  TextureRef t = fetchTextureRef(ref != 0u ? ref : materialRow);
  if (kTextures && ref != 0u) {
    vec4 uv = interpolatedUv(corners, weights);
    bool second = (t.bits & TEXEL_UV1) != 0u;
    opacity *= lookUp(t, second ? uv.z : uv.x, second ? uv.w : uv.y, 0u).w;
  }
  return opacity;
}

// Share of the rays that meet this point of a triangle; the weights sum to 1.
float presenceAt(uint primitive, uint triangle, vec3 weights, Layout l) {
  uint row = params.materialRow + primitive * MATERIAL_ROWS;
  uint bits = floatBitsToUint(fetchRow(row + 1u).w);
  float presence = 1.0;
  if ((bits & MATERIAL_ALPHA) != 0u) {
    float opacity = opacityAt(row, primitive, triangle, weights, l);
    bool masked = (bits & MATERIAL_MASK) != 0u;
    presence = masked ? (opacity >= fetchRow(row + 7u).z ? 1.0 : 0.0) : clamp(opacity, 0.0, 1.0);
  }
  return presence;
}

// Whether a ray meets the point; weights need not sum to 1.
bool isMet(uint primitive, uint triangle, vec3 weights) {
  vec3 whole = weights / (weights.x + weights.y + weights.z);
  float presence = presenceAt(primitive, triangle, whole, primitiveLayout());
  float chance = unitFloat(hashCombine(hashCombine(alphaSeed, triangle), primitive));
  return alphaSeed == 0u ? presence > 0.0 : chance < presence;
}

#endif
