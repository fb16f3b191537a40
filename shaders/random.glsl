// SPDX-License-Identifier: MIT
// Counter-based samples: Owen-scrambled Sobol pairs keyed by (pixel, sample index, dimension), never by frame or
// tile. Padding as Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020. Binding-free, loop-free.
#ifndef RANDOM_GLSL
#define RANDOM_GLSL

// Integer hash of low bias (Wellons, "Prospecting for Hash Functions", 2018).
uint hashUint(uint x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  x ^= x >> 16;
  return x;
}

uint hashCombine(uint seed, uint value) { return hashUint(seed ^ (value * 0x9e3779b9u + 0x7f4a7c15u)); }

// Laine-Karras style permutation of bit-reversed values: every bit depends on the lower ones only, which is a
// nested uniform (Owen) scramble after reversal. Constants: Vegdahl, "Building a Better LK Hash", 2021.
uint permuteReversed(uint x, uint seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// Bit-reversed second Sobol dimension: its matrix is Pascal's triangle mod 2, a superset sum over the bits.
uint sobolSecondReversed(uint index) {
  uint x = index;
  x ^= (x & 0xaaaaaaaau) >> 1;
  x ^= (x & 0xccccccccu) >> 2;
  x ^= (x & 0xf0f0f0f0u) >> 4;
  x ^= (x & 0xff00ff00u) >> 8;
  x ^= x >> 16;
  return x;
}

// [0, 1) with 24 bits: dividing all 32 by 2^32 would round up to exactly 1 now and then.
float unitFloat(uint bits) { return float(bits >> 8) * 5.9604644775390625e-8; }

struct SamplePair {
  float x;
  float y;
};

// The pair number `dimension` of sample `index`; `pixelSeed` holds pixel, half and user seed.
SamplePair samplePair(uint pixelSeed, uint index, uint dimension) {
  uint seed = hashCombine(pixelSeed, dimension);
  uint shuffled = bitfieldReverse(permuteReversed(bitfieldReverse(index), seed));
  // The two scrambles take their lowest bits, which flip the halves of the square, from different bits of the seed.
  uint x = bitfieldReverse(permuteReversed(shuffled, seed * 0x9e3779b1u + 0x68bc21ebu));
  uint y = bitfieldReverse(permuteReversed(sobolSecondReversed(shuffled), ((seed >> 16) | (seed << 16)) * 0x85ebca77u + 0x02e5be93u));
  return SamplePair(unitFloat(x), unitFloat(y));
}

// An independent number for decisions that gain nothing from stratification (Russian roulette, light strata).
float sampleIndependent(uint pixelSeed, uint index, uint dimension) {
  return unitFloat(hashUint(pixelSeed ^ (index * 0x9e3779b9u + dimension * 0x85ebca77u + 0xb5297a4du)));
}

// A permuted congruential generator over three integers: a step of an LCG each, then mixed by multiply-adds and one
// xorshift. Jarzynski & Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020, pcg3d.
uvec3 pcg3d(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

// As samplePair, but independent of every other sample: what stratification is measured against.
SamplePair pcgPair(uint pixelSeed, uint index, uint dimension) {
  uvec3 v = pcg3d(uvec3(pixelSeed, index, dimension));
  return SamplePair(unitFloat(v.x), unitFloat(v.y));
}

uint pixelSeedOf(uint x, uint y, uint halfBuffer, uint seed) {
  return hashCombine(hashCombine(hashUint(x ^ (y << 16)), halfBuffer), seed);
}

#endif
