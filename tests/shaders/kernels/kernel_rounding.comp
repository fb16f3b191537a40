#version 460
// SPDX-License-Identifier: MIT
// rounding.glsl on the device.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "rounding.glsl"

void main() {
  uint at = invocation();
  answers[at] = rounded(kOperation, questions[5u * at], questions[5u * at + 1u], questions[5u * at + 2u],
                        questions[5u * at + 3u], questions[5u * at + 4u]);
}
