// SPDX-License-Identifier: MIT
// The film: per pixel and half-buffer a compensated sum of radiance. The spare components count, in whole numbers:
// sumA.w closest rays, sumB.w shadow rays, carryA.w NaN samples (dropped), carryB.w faults (see path_trace.comp).
#ifndef FILM_GLSL
#define FILM_GLSL
#include "gpu_types.h"
#include "numerics.glsl"

layout(set = 0, binding = 1) buffer SumA { vec4 sumA[]; };
layout(set = 0, binding = 2) buffer CarryA { vec4 carryA[]; };
layout(set = 0, binding = 3) buffer SumB { vec4 sumB[]; };
layout(set = 0, binding = 4) buffer CarryB { vec4 carryB[]; };

// Samples in each half of the pixel at this index.
uvec2 halfSamples(FilmParams film, uint at) {
  return at / film.width < film.splitRow ? uvec2(film.aheadA, film.aheadB) : uvec2(film.samplesA, film.samplesB);
}

#endif
