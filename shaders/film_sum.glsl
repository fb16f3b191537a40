// SPDX-License-Identifier: MIT
// Sums of radiance in fixed point. Integers add exactly and in any order, so that any split of the samples into passes, parts
// and pauses gives the same bytes. Binding-free.
#ifndef FILM_SUM_GLSL
#define FILM_SUM_GLSL
#include "gpu_types.h"

const float PER_FILM_BASE = 1.0 / float(FILM_BASE);

// In film units: high + middle / FILM_BASE + low / FILM_BASE^2, 0 <= middle, low < FILM_BASE.
struct FilmSum {
  ivec3 low;
  ivec3 middle;
  ivec3 high;
};

// By bits: isnan() and isinf() are not guaranteed without SignedZeroInfNanPreserve.
bool isFiniteBits(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }
bool isFiniteVec(vec3 v) { return isFiniteBits(v.x) && isFiniteBits(v.y) && isFiniteBits(v.z); }

// The largest float below FILM_BASE: what is brighter counts as that, and makes the sum full.
const float FILM_MOST = 1073741760.0;
vec3 withinFilm(vec3 units) { return clamp(units, vec3(-FILM_MOST), vec3(FILM_MOST)); }

// `units` must lie within the film. It falls into digits of its own sign: each step takes off the leading bits of what is
// left, which is exact in floats. What lies below the last digit is cut off: at most 2^-48 of white (renderer/film_unit.hpp),
// where a pixel's noise is above 2^-10 of its light even after a million samples. A sum beyond the high digit stays at its end.
FilmSum addToFilm(FilmSum sum, vec3 units) {
  ivec3 high = ivec3(units);
  precise vec3 rest = (units - vec3(high)) * float(FILM_BASE);
  ivec3 middle = ivec3(rest);
  precise vec3 least = (rest - vec3(middle)) * float(FILM_BASE);
  ivec3 low = sum.low + ivec3(least);
  middle += sum.middle + (low >> FILM_DIGIT_BITS);
  high += sum.high + (middle >> FILM_DIGIT_BITS);
  return FilmSum(low & (FILM_BASE - 1), middle & (FILM_BASE - 1), clamp(high, -FILM_BASE, FILM_BASE));
}

bool isFull(FilmSum sum) {
  ivec3 size = abs(sum.high);
  return max(size.x, max(size.y, size.z)) >= int(FILM_MOST);
}

// Within a few 2^-24 of the sum, however small: the high digit of a negative one first lends to the others, so that all have
// one sign.
vec3 unitsOf(FilmSum sum) {
  ivec3 lent = sum.high >> 31;
  vec3 rest = vec3(sum.middle + lent * (FILM_BASE - 1)) + vec3(sum.low + lent * FILM_BASE) * PER_FILM_BASE;
  return vec3(sum.high - lent) + rest * PER_FILM_BASE;
}

#endif
