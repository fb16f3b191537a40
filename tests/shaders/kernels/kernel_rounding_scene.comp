#version 460
// SPDX-License-Identifier: MIT
// rounding_scene.glsl on the device.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "rounding_scene.glsl"

void main() {
  uint at = invocation();
  answers[at] = roundedOfScene(kOperation, questions[2u * at], questions[2u * at + 1u]);
}
