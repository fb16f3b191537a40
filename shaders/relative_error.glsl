// SPDX-License-Identifier: MIT
// Squared errors over squared light, where neither is known: the light of a pixel is judged by the pixels around it. Its own
// mean will not do: where a path happened to find a light both the mean and the difference of the halves are large, and the
// quotient says that all is well. renderer/relative_error.cpp is the same in double. Binding-free.
#ifndef RELATIVE_ERROR_GLSL
#define RELATIVE_ERROR_GLSL

// What is averaged around a pixel. Fourth roots let neither one bright pixel nor one black one decide.
vec3 levelRoot(vec3 mean) { return sqrt(sqrt(max(mean, vec3(0.0)))); }
vec3 levelOf(vec3 root) { return (root * root) * (root * root); }

// `variance` of a pixel's mean, `level` of the light around it: taken as far as the pixel's own halves bear it out.
vec3 relativeSquares(vec3 variance, vec3 mean, vec3 level, float floorSquare) {
  vec3 deviation = sqrt(variance);
  vec3 light = clamp(level, mean - deviation, mean + deviation);
  return variance / (light * light + floorSquare);
}

#endif
