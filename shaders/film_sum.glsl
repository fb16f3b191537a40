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

// Not so what is no number, infinite, or beyond the high digit. By bits: isnan() and isinf() are not guaranteed without
// SignedZeroInfNanPreserve.
bool fitsFilm(float units) { return int(floatBitsToUint(units) & 0x7fffffffu) < int(floatBitsToUint(float(FILM_BASE))); }
bool fitsFilm(vec3 units) { return fitsFilm(units.x) && fitsFilm(units.y) && fitsFilm(units.z); }

// `units` must fit. It falls into digits of its own sign: each step takes off the leading bits of what is left, which is exact
// in floats. What lies below the last digit is cut off: at most 2^-48 of white (renderer/film_unit.hpp), where a pixel's noise
// is above 2^-10 of its light even after a million samples. A sum beyond the high digit stays at its end.
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
  return max(size.x, max(size.y, size.z)) >= FILM_BASE;
}

// Within a few 2^-24 of the sum, however small: the high digit of a negative one first lends to the others, so that all have
// one sign.
vec3 unitsOf(FilmSum sum) {
  ivec3 lent = sum.high >> 31;
  vec3 rest = vec3(sum.middle + lent * (FILM_BASE - 1)) + vec3(sum.low + lent * FILM_BASE) * PER_FILM_BASE;
  return vec3(sum.high - lent) + rest * PER_FILM_BASE;
}

#endif
