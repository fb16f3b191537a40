// SPDX-License-Identifier: MIT
// Textures in a buffer of words (renderer/gpu_textures.hpp): wrapped, bilinear or nearest lookups of one mip level.
#ifndef TEXTURE_GLSL
#define TEXTURE_GLSL
#include "scene.glsl"

// A texture in one place of a material.
struct TextureRef {
  uint first;  // word
  uint width;
  uint height;
  uint bits;   // TEXEL_*
  vec3 transformX;
  vec3 transformY;
};

TextureRef fetchTextureRef(uint row) {
  vec4 a = fetchRow(row);
  return TextureRef(floatBitsToUint(a.x), floatBitsToUint(a.y), floatBitsToUint(a.z), floatBitsToUint(a.w), fetchRow(row + 1u).xyz,
                    fetchRow(row + 2u).xyz);
}

// Into the texture, or, mirrored, into it and its mirror image: [0, 1] or [0, 2].
float wrapped(float u, uint wrap) {
  float period = wrap == WRAP_MIRROR ? 2.0 : 1.0;
  float folded = u - period * floor(u * (1.0 / period));
  return wrap == WRAP_CLAMP ? clamp(u, 0.0, 1.0) : folded;
}

// The texel at place i of n: from one before the texture to one behind it, or behind its mirror image.
int wrappedTexel(int i, int n, uint wrap) {
  int repeated = i < 0 ? i + n : (i >= n ? i - n : i);
  int mirrored = i >= n ? 2 * n - 1 - i : i;
  int folded = wrap == WRAP_REPEAT ? repeated : (wrap == WRAP_MIRROR ? mirrored : i);
  return clamp(folded, 0, n - 1);
}

vec4 halvesOf(uint a, uint b) {
  vec2 low = unpackHalf2x16(a);
  vec2 high = unpackHalf2x16(b);
  return vec4(low.x, low.y, high.x, high.y);
}

// The texel whose first word is `at`, linear.
vec4 texelValue(uint bits, uint at) {
  uint format = bits & TEXEL_FORMAT_MASK;
  bool eight = format == TEXEL_RGBA8;
  uint a = fetchTexel(at);
  uint b = fetchTexel(eight ? at : at + 1u);
  uint red = eight ? a & 255u : a & 65535u;
  uint green = eight ? (a >> 8) & 255u : a >> 16;
  uint blue = eight ? (a >> 16) & 255u : b & 65535u;
  uint alpha = eight ? a >> 24 : b >> 16;
  float most = eight ? 255.0 : 65535.0;
  vec4 value = vec4(float(int(red)) / most, float(int(green)) / most, float(int(blue)) / most, float(int(alpha)) / most);
  if ((bits & TEXEL_SRGB) != 0u) {
    uint table = eight ? 0u : TEXEL_SRGB16;
    value.x = uintBitsToFloat(fetchTexel(table + red));
    value.y = uintBitsToFloat(fetchTexel(table + green));
    value.z = uintBitsToFloat(fetchTexel(table + blue));
  }
  if (format == TEXEL_HALF) value = halvesOf(a, b);
  return value;
}

// (u, v) before the texture's own transform; (0, 0) is the top left corner of the top left texel.
vec4 lookUp(TextureRef t, float u, float v, uint level) {
  uint wrapU = (t.bits >> TEXEL_WRAP_U_SHIFT) & 3u;
  uint wrapV = (t.bits >> TEXEL_WRAP_V_SHIFT) & 3u;
  int width = int(max(t.width >> level, 1u));
  int height = int(max(t.height >> level, 1u));
  float across = wrapped(t.transformX.x * u + t.transformX.y * v + t.transformX.z, wrapU) * float(width);
  float down = wrapped(t.transformY.x * u + t.transformY.y * v + t.transformY.z, wrapV) * float(height);
  bool nearest = (t.bits & TEXEL_NEAREST) != 0u;
  float x = nearest ? floor(across) : across - 0.5;
  float y = nearest ? floor(down) : down - 0.5;
  float left = floor(x);
  float top = floor(y);
  int column = int(left);
  int line = int(top);
  uint base = t.first + fetchTexel(t.first + level);
  uint size = (t.bits & TEXEL_FORMAT_MASK) == TEXEL_RGBA8 ? 1u : 2u;
  uint column0 = uint(wrappedTexel(column, width, wrapU)) * size;
  uint column1 = uint(wrappedTexel(column + 1, width, wrapU)) * size;
  uint row0 = base + uint(wrappedTexel(line, height, wrapV) * width) * size;
  uint row1 = base + uint(wrappedTexel(line + 1, height, wrapV) * width) * size;
  float fx = x - left;
  float fy = y - top;
  // `precise`: all variants must round these alike.
  precise vec4 upper = texelValue(t.bits, row0 + column0) * (1.0 - fx) + texelValue(t.bits, row0 + column1) * fx;
  precise vec4 lower = texelValue(t.bits, row1 + column0) * (1.0 - fx) + texelValue(t.bits, row1 + column1) * fx;
  precise vec4 value = upper * (1.0 - fy) + lower * fy;
  return value;
}

// Mip level for a footprint of so many metres, where the texture coordinates run at so many units per metre; `jitter`
// in [0, 1) chooses between the two nearest, which on average blends them (Fajardo et al., Stochastic Texture
// Filtering, 2023).
uint mipLevel(TextureRef t, float footprint, float uvPerMetre, float jitter) {
  float stretch = abs(t.transformX.x * t.transformY.y - t.transformX.y * t.transformY.x);
  float texels = footprint * uvPerMetre * sqrt(stretch * float(int(t.width)) * float(int(t.height)));
  float level = log2(clamp(texels, 1.0, 1e9)) + jitter;
  return min(uint(level), (t.bits >> TEXEL_LEVELS_SHIFT) - 1u);
}

#endif
