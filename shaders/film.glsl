// SPDX-License-Identifier: MIT
// The film as a whole, as resolve and meter read it: digits of half A and B (gpu_types.h).
#ifndef FILM_GLSL
#define FILM_GLSL
#include "film_sum.glsl"

layout(set = 0, binding = 11) uniform isamplerBuffer lowA;
layout(set = 0, binding = 12) uniform isamplerBuffer middleA;
layout(set = 0, binding = 13) uniform isamplerBuffer highA;
layout(set = 0, binding = 14) uniform isamplerBuffer lowB;
layout(set = 0, binding = 15) uniform isamplerBuffer middleB;
layout(set = 0, binding = 16) uniform isamplerBuffer highB;

// One half of a pixel.
struct FilmHalf {
  vec3 sum;  // of radiance
  float closestRays, shadowRays;
};

FilmHalf halfOf(ivec4 low, ivec4 middle, ivec4 high, float unit) {
  return FilmHalf(unitsOf(FilmSum(low.xyz, middle.xyz, high.xyz)) * unit, float(uint(low.w)), float(uint(middle.w)));
}
FilmHalf fetchHalfA(FilmParams film, uint index) {
  int at = int(index);
  return halfOf(texelFetch(lowA, at), texelFetch(middleA, at), texelFetch(highA, at), film.filmUnit);
}
FilmHalf fetchHalfB(FilmParams film, uint index) {
  int at = int(index);
  return halfOf(texelFetch(lowB, at), texelFetch(middleB, at), texelFetch(highB, at), film.filmUnit);
}

// Samples in each half of the pixel at this index.
uvec2 halfSamples(FilmParams film, uint at) {
  return at < film.splitPixel ? uvec2(film.aheadA, film.aheadB) : uvec2(film.samplesA, film.samplesB);
}

#endif
