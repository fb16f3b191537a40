#version 460
// SPDX-License-Identifier: MIT
// numerics.glsl: exact sums and products, frames; and the built-in sine and cosine.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "numerics.glsl"

void main() {
  uint at = invocation();
  if (kOperation == 0u) {
    vec4 q = questions[at];
    DoubleFloat sum = twoSum(q.x, q.y);
    DoubleFloat product = twoProduct(q.x, q.y);
    answers[at] = vec4(sum.hi, sum.lo, product.hi, product.lo);
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
    answers[at] = vec4(maxComponent(vec3(1.0, 3.0, 2.0)), luminance(vec3(1.0)), 0.0, 0.0);
  }
}
