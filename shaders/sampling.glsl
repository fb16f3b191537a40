// SPDX-License-Identifier: MIT
// Warps from the unit square to directions, local frame, +Z the normal. Binding-free.
#ifndef SAMPLING_GLSL
#define SAMPLING_GLSL
#include "numerics.glsl"

// Cosine-weighted hemisphere; pdf = z / pi. (c, s) = cosine and sine of the azimuth.
vec3 cosineHemisphere(float c, float s, float u) {
  float r = sqrt(u);
  return vec3(r * c, r * s, sqrt(1.0 - u));
}

// GGX normal visible from wo by sampling a spherical cap (Dupuy & Benyoub, CGF 42(8), 2023).
vec3 visibleNormal(vec3 wo, float alpha, float c, float s, float u) {
  vec3 v = normalize(vec3(wo.x * alpha, wo.y * alpha, wo.z));
  float z = (1.0 - u) * (1.0 + v.z) - v.z;
  float r = sqrt(max(0.0, 1.0 - z * z));
  vec3 h = vec3(r * c + v.x, r * s + v.y, z + v.z);
  return normalize(vec3(h.x * alpha, h.y * alpha, max(h.z, 1e-6)));
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
