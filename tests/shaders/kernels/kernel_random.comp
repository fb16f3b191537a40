#version 460
// SPDX-License-Identifier: MIT
// random.glsl: hashes, sample pairs, the second Sobol dimension.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "random.glsl"

// samples: samples per pixel of operation 1; dimension and half of what is drawn; begin: first index or hash.
layout(push_constant) uniform Push { uint samples, dimension, halfBuffer, begin; };

vec4 split(uint a, uint b) { return vec4(a >> 16, a & 0xffffu, b >> 16, b & 0xffffu); }

void main() {
  uint at = invocation();
  if (kOperation == 0u) {
    // Largest of 64 numbers, and of the same hashes with their low bits set (the worst for rounding).
    float largest = 0.0;
    for (uint i = 0u; i < 64u; ++i) {
      uint h = hashUint(begin + at * 64u + i);
      largest = max(largest, max(unitFloat(h), unitFloat(h | 0xffu)));
    }
    answers[at] = vec4(largest, unitFloat(0xffffffffu), unitFloat(0u), 0.0);
  } else if (kOperation == 1u) {
    uint pixel = at / samples;
    uint index = begin + at % samples;
    uint seed = pixelSeedOf(pixel % 512u, pixel / 512u, halfBuffer, 7u);
    SamplePair pair = samplePair(seed, index, dimension);
    answers[at] = vec4(pair.x, pair.y, sampleIndependent(seed, index, dimension),
                       sampleIndependent(seed, index, dimension + 0x20000u));
  } else if (kOperation == 3u) {
    uint index = begin + at % samples;
    uint seed = pixelSeedOf((at / samples) % 512u, (at / samples) / 512u, halfBuffer, 7u);
    SamplePair pair = pcgPair(seed, index, dimension);
    SamplePair next = pcgPair(seed, index, dimension + 1u);
    answers[at] = vec4(pair.x, pair.y, next.x, next.y);
  } else if (kOperation == 4u) {
    uvec3 v = pcg3d(uvec3(begin + at, at * 3u, 7u));
    answers[at] = split(v.x, v.y);
  } else {
    uint index = at < 4096u ? at : hashUint(at);
    answers[at] = split(index, sobolSecondReversed(index));
  }
}
