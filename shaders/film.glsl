// SPDX-License-Identifier: MIT
// The film as a whole: per pixel and half-buffer a compensated sum of radiance. The spare components count rays, in
// whole numbers: sum.w closest hits, carry.w shadow rays.
#ifndef FILM_GLSL
#define FILM_GLSL
#include "gpu_types.h"

layout(set = 0, binding = 1) buffer SumA { vec4 sumA[]; };
layout(set = 0, binding = 2) buffer CarryA { vec4 carryA[]; };
layout(set = 0, binding = 3) buffer SumB { vec4 sumB[]; };
layout(set = 0, binding = 4) buffer CarryB { vec4 carryB[]; };

// Samples in each half of the pixel at this index.
uvec2 halfSamples(FilmParams film, uint at) {
  return at < film.splitPixel ? uvec2(film.aheadA, film.aheadB) : uvec2(film.samplesA, film.samplesB);
}

#endif
