// SPDX-License-Identifier: MIT
// The film as a whole: per pixel and half-buffer a compensated sum of radiance. The spare components count rays, in
// whole numbers: sum.w closest hits, carry.w shadow rays.
#ifndef FILM_GLSL
#define FILM_GLSL
#include "gpu_types.h"

layout(set = 0, binding = 11) uniform samplerBuffer sumA;
layout(set = 0, binding = 12) uniform samplerBuffer carryA;
layout(set = 0, binding = 13) uniform samplerBuffer sumB;
layout(set = 0, binding = 14) uniform samplerBuffer carryB;

vec4 fetchFilm(samplerBuffer film, uint at) { return texelFetch(film, int(at)); }

// Samples in each half of the pixel at this index.
uvec2 halfSamples(FilmParams film, uint at) {
  return at < film.splitPixel ? uvec2(film.aheadA, film.aheadB) : uvec2(film.samplesA, film.samplesB);
}

#endif
