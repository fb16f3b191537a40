// SPDX-License-Identifier: MIT
// Warps from the unit square to directions, local frame, +Z the normal. Binding-free.
#ifndef SAMPLING_GLSL
#define SAMPLING_GLSL
#include "numerics.glsl"

struct CosSin {
  float c;
  float s;
};

// Cosine and sine of 2 pi u for u in [0, 1): folded to an eighth turn, then minimax polynomials (Moshier, Cephes
// sinf/cosf). Vulkan's own sin and cos may err by 2^-11, and cost more.
CosSin cosSinTurn(float u) {
  float quarter = floor(u * 4.0 + 0.5);
  float x = (u - quarter * 0.25) * (2.0 * PI);
  float x2 = x * x;
  float s = x + x * x2 * (-1.6666654611e-1 + x2 * (8.3321608736e-3 - x2 * 1.9515295891e-4));
  float c = 1.0 - 0.5 * x2 + x2 * x2 * (4.166664568298827e-2 + x2 * (-1.388731625493765e-3 + x2 * 2.443315711809948e-5));
  bool odd = quarter == 1.0 || quarter == 3.0;
  float cosine = odd ? s : c;
  float sine = odd ? c : s;
  return CosSin(quarter == 1.0 || quarter == 2.0 ? -cosine : cosine, quarter == 2.0 || quarter == 3.0 ? -sine : sine);
}

// Cosine-weighted hemisphere; pdf = z / pi. (c, s) = cosine and sine of the azimuth.
vec3 cosineHemisphere(float c, float s, float u) {
  float r = sqrt(u);
  return vec3(r * c, r * s, sqrt(1.0 - u));
}

// GGX normal visible from wo, not normalized, by sampling a spherical cap (Dupuy & Benyoub, CGF 42(8), 2023).
// stretchedLength = |(alpha x, alpha y, z)| of wo, which is ggxA(wo.z, alpha).
vec3 visibleNormal(vec3 wo, float alpha, float stretchedLength, float c, float s, float u) {
  float inv = 1.0 / stretchedLength;
  vec3 v = vec3(wo.x * alpha * inv, wo.y * alpha * inv, wo.z * inv);
  float z = (1.0 - u) * (1.0 + v.z) - v.z;
  float r = sqrt(max(0.0, 1.0 - z * z));
  return vec3((r * c + v.x) * alpha, (r * s + v.y) * alpha, max(z + v.z, 1e-6));
}

// GGX normal by D cos alone, not normalized (Walter et al. 2007, eq. 35).
vec3 anyNormal(float alpha, float c, float s, float u) {
  float r = alpha * sqrt(u);
  return vec3(r * c, r * s, max(sqrt(1.0 - u), 1e-6));
}

// Power heuristic (Veach & Guibas 1995) by ratio, so that large densities do not overflow and 0 or infinity (a
// delta) give the limit instead of NaN.
float powerHeuristic(float pdf, float otherPdf) {
  if (otherPdf <= 0.0) return 1.0;
  if (pdf <= 0.0) return 0.0;
  float ratio = otherPdf / pdf;
  bool certain = (floatBitsToUint(pdf) & 0x7f800000u) == 0x7f800000u;
  return certain ? 1.0 : 1.0 / (1.0 + ratio * ratio);
}

#endif
