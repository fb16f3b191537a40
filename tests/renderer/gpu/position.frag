#version 460
// SPDX-License-Identifier: MIT
// Writes where the pixel is and what the storage buffer holds.
layout(set = 0, binding = 1) readonly buffer Values { float values[]; };
layout(push_constant) uniform Push { float scale; };
layout(location = 0) out vec4 colour;

void main() { colour = vec4(gl_FragCoord.xy * scale, values[0], 1.0); }
