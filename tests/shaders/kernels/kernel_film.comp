#version 460
// SPDX-License-Identifier: MIT
// film_sum.glsl: sums of rows, or of many samples as a film sees them; and their floats.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "film_sum.glsl"

layout(push_constant) uniform Push { uint additions, begin; };

// A sum is 6 rows of halved digits, which floats hold exactly: upper and lower 15 bits of low, middle, high.
ivec3 digitAt(uint row) { return ivec3(questions[row].xyz) * 32768 + ivec3(questions[row + 1u].xyz); }
void writeDigit(uint row, ivec3 digit) {
  answers[row].xyz = vec3(digit >> 15);
  answers[row + 1u].xyz = vec3(digit & 32767);
}

// 0.1; 0.5 with a firefly of 1e4 every hundredth time; a ramp.
vec3 sampleAt(uint n) { return vec3(0.1, n % 100u == 99u ? 1e4 : 0.5, float(n & 1023u) * 0.0009765625); }

// The sum in front of each invocation's rows, and these rows or samples added to it. In w of the answer's first rows what was
// dropped, and whether the sum is full.
void main() {
  uint at = invocation();
  bool rows = kOperation == 0u;
  uint first = at * (6u + (rows ? additions : 0u));
  FilmSum sum = FilmSum(digitAt(first), digitAt(first + 2u), digitAt(first + 4u));
  if (kOperation == 2u) {
    answers[at] = vec4(unitsOf(sum), 0.0);
    return;
  }
  uint dropped = 0u;
  for (uint i = 0u; i < additions; ++i) {
    vec3 units = rows ? questions[first + 6u + i].xyz : sampleAt(begin + i);
    bool finite = isFiniteVec(units);
    dropped += finite ? 0u : 1u;
    sum = addToFilm(sum, finite ? withinFilm(units) : vec3(0.0));
  }
  writeDigit(6u * at, sum.low);
  writeDigit(6u * at + 2u, sum.middle);
  writeDigit(6u * at + 4u, sum.high);
  answers[6u * at].w = float(dropped);
  answers[6u * at + 1u].w = isFull(sum) ? 1.0 : 0.0;
}
