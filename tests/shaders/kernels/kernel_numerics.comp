#version 460
// SPDX-License-Identifier: MIT
// numerics.glsl: exact sums and products, compensated sums, frames; and the built-in sine and cosine.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "numerics.glsl"

layout(push_constant) uniform Push { uint additions; };

// 3 rows in: sum, carry, (begin, -, -, plain sum). Adds 0.1; 0.5 with a firefly of 1e4 every hundredth time; a ramp.
void accumulate(uint at) {
  Compensated total = Compensated(questions[3u * at].xyz, questions[3u * at + 1u].xyz);
  uint begin = uint(questions[3u * at + 2u].x);
  float plain = questions[3u * at + 2u].w;
  for (uint i = 0u; i < additions; ++i) {
    uint n = begin + i;
    vec3 value = vec3(0.1, n % 100u == 99u ? 1e4 : 0.5, float(n & 1023u) * 0.0009765625);
    total = compensatedAdd(total, value);
    plain += value.x;
  }
  answers[2u * at] = vec4(total.sum, plain);
  answers[2u * at + 1u] = vec4(total.carry, 0.0);
}

void main() {
  uint at = invocation();
  if (kOperation == 0u) {
    vec4 q = questions[at];
    DoubleFloat sum = twoSum(q.x, q.y);
    DoubleFloat product = twoProduct(q.x, q.y);
    answers[at] = vec4(sum.hi, sum.lo, product.hi, product.lo);
  } else if (kOperation == 1u) {
    accumulate(at);
  } else if (kOperation == 2u) {
    Frame f = frameAround(questions[at].xyz);
    answers[3u * at] = vec4(f.t, 0.0);
    answers[3u * at + 1u] = vec4(f.b, 0.0);
    answers[3u * at + 2u] = vec4(toWorld(f, toLocal(f, vec3(0.6, 0.0, 0.8))), 0.0);
  } else if (kOperation == 3u) {
    vec4 q = questions[at];
    DoubleFloat sum = addDouble(DoubleFloat(q.x, q.y), DoubleFloat(q.z, q.w));
    DoubleFloat square = squareDouble(DoubleFloat(q.x, q.y));
    answers[at] = vec4(sum.hi, sum.lo, square.hi, square.lo);
  } else if (kOperation == 4u) {
    float v = questions[at].x;
    answers[at] = vec4(sin(2.0 * PI * v), cos(2.0 * PI * v), 0.0, 0.0);
  } else {
    float x = questions[at].x;
    answers[at] = vec4(isFiniteBits(x) ? 1.0 : 0.0, isFiniteVec(vec3(1.0, x, 2.0)) ? 1.0 : 0.0,
                       maxComponent(vec3(1.0, 3.0, 2.0)), luminance(vec3(1.0)));
  }
}
