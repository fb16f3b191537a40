#version 460
// SPDX-License-Identifier: MIT
// Adds samples [sampleBegin, sampleEnd) of one half-buffer to every pixel of rows [rowBegin, rowEnd): paths with
// next-event estimation and multiple importance sampling. One loop level: each turn traces one path segment, and a path that ended makes room for the
// next sample at once. Samples add up exactly, so any split into dispatches gives the same bytes.
#extension GL_GOOGLE_include_directive : require
#include "film_sum.glsl"
#include "path.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// The half-buffer of this dispatch (digits as gpu_types.h says), and what must stay 0. Each invocation reads its pixel as
// texels before it writes it: CPU drivers read those several times as fast.
layout(set = 0, binding = 11) uniform isamplerBuffer lowBefore;
layout(set = 0, binding = 12) uniform isamplerBuffer middleBefore;
layout(set = 0, binding = 13) uniform isamplerBuffer highBefore;
layout(set = 0, binding = 1) buffer Low { ivec4 filmLow[]; };
layout(set = 0, binding = 2) buffer Middle { ivec4 filmMiddle[]; };
layout(set = 0, binding = 3) buffer High { ivec4 filmHigh[]; };
layout(set = 0, binding = 5) buffer Counters { uint counters[COUNTERS]; };

// Pixel order interleaved by rows of groups: some drivers give each thread a fixed half of the groups.
uvec2 pixelOfInvocation() {
  uint groups = gl_NumWorkGroups.y;
  uint firstHalf = (groups + 1u) / 2u;
  uint g = gl_WorkGroupID.y;
  uint row = g < firstHalf ? 2u * g : 2u * (g - firstHalf) + 1u;
  return uvec2(gl_GlobalInvocationID.x, params.rowBegin + row * gl_WorkGroupSize.y + gl_LocalInvocationID.y);
}

// 64 bits from two counters: whole units, so that the total does not depend on the order.
void countClamped(float cut) {
  if (!(cut > 0.0)) return;
  float units = floor(min(cut / params.clampRadiance * float(CLAMPED_UNITS), 1e15) + 0.5);
  float high = floor(units / 4294967296.0);
  uint low = uint(units - high * 4294967296.0);
  uint before = atomicAdd(counters[COUNTER_CLAMPED_LOW], low);
  uint more = uint(high) + (before + low < before ? 1u : 0u);
  if (more > 0u) atomicAdd(counters[COUNTER_CLAMPED_HIGH], more);
}

void main() {
  uvec2 pixel = pixelOfInvocation();
  if (pixel.x >= params.width || pixel.y >= params.rowEnd) return;
  uint at = pixel.y * params.width + pixel.x;
  Layout l = primitiveLayout();
  CameraRows camera = fetchCamera();
  loadBakedPrimitives();
  loadBakedLights();
  ivec4 low = texelFetch(lowBefore, int(at));
  ivec4 middle = texelFetch(middleBefore, int(at));
  FilmSum total = FilmSum(low.xyz, middle.xyz, texelFetch(highBefore, int(at)).xyz);
  Tally tally = Tally(0u, 0u, 0u, 0u, 0.0);

  uint seed = pixelSeedOf(pixel.x, pixel.y, params.flags & TRACE_HALF_B, params.seed);
  Path path = cameraPath(camera, pixel, pairAt(seed, params.sampleBegin, 0u), seed, params.sampleBegin);

  uint last = lastBounce();

  // Every turn lengthens a path or ends it, so the turns are bounded by samples * (last + 1).
  while (path.index < params.sampleEnd) {
    // Find the next vertex.
    Hit hit = nextHit(path, seed, l);
    tally.closestRays += 1u;
    bool missed = hit.primitive == NO_PRIMITIVE;
    bool alive = maxComponent(path.throughput) > 0.0;
    uint primitive = min(hit.primitive, l.end - 1u);
    Vertex v = vertexAt(Hit(hit.t, primitive, hit.triangle), path, seed, l);
    if (kAbsorption && alive) path.throughput *= exp(-path.absorption * hit.t);
    BakedSamples baked = sampleBakedLights(v);

    // Decide whether the path ends: nothing left to carry, bounce limit, then Russian roulette.
    bool ended = missed || !alive || path.bounce >= last;
    float survival = survivalOf(path);
    if (roulettePlayed(path)) ended = ended || sampleIndependent(seed, path.index, path.bounce) >= survival;

    // Draw one pair: for the camera of the next path, or for the next direction of this one. The direction is drawn before
    // the lights are looked at and weighed after that: work to do while its long chain of operations runs.
    uint index = ended ? path.index + 1u : path.index;
    SamplePair pair = pairAt(seed, index, ended ? 0u : path.bounce + 1u);
    Lobes lobes = lobesAt(v.material, primitive, v.wo.z, v.inside, v.thin);
    BsdfDraw drawn = drawBsdf(lobes, v.wo, pair.x, pair.y, facetNumber(seed, path.index, path.bounce), lobeKinds());

    // Add what the surface emits, and what the lights send it; or what the sky sends.
    bool lit = !missed && alive && samplesLights(path);
    vec3 arriving = vec3(0.0);
    if (kFixedLights > 0u) arriving = lightFromBakedLights(baked, lit, v, lobes, tally, l);
    if (kLights && kFixedLights == 0u && lit) arriving = lightFromLights(v, lobes, tally, l);
    if (kSampledSky && lit) arriving += lightFromEnvironment(v, lobes, tally, l);
    if (missed && alive) {
      if (kEnvironment || kSuns) addLight(path, tally, skyLight(path), path.bounce);
    }
    if (!missed && alive) {
      tally.missing |= missingFeatures(v.material.bits);
      if (kEmission) addLight(path, tally, emittedLight(v, path), path.bounce);
      if (kLights || kSampledSky) addLight(path, tally, arriving, path.bounce + 1u);
    }
    if (kRoulette) path.throughput /= max(survival, 1e-30);
    goOn(path, hit.t, v, lobes.eta, weighDraw(lobes, drawn, v.wo, lobeKinds()));

    // Commit a finished sample and start the next one.
    if (ended) {
      vec3 units = path.radiance * params.perFilmUnit;
      bool finite = isFiniteVec(units);
      tally.nan += finite ? 0u : 1u;
      total = addToFilm(total, finite ? withinFilm(units) : vec3(0.0));
      path = cameraPath(camera, pixel, pair, seed, index);
    }
  }

  filmLow[at] = ivec4(total.low, low.w + int(tally.closestRays));
  filmMiddle[at] = ivec4(total.middle, middle.w + int(tally.shadowRays));
  filmHigh[at].xyz = total.high;
  // A sample that the loop budget cut off is a fault, never a silently darker pixel; so is a sum that no longer grows.
  uint faults = (params.sampleEnd - min(path.index, params.sampleEnd)) + (tally.missing != 0u ? 1u : 0u) + (isFull(total) ? 1u : 0u) + ((kMeshes || kShapeHierarchy) && traversalCut ? 1u : 0u);
  if (tally.nan > 0u) atomicAdd(counters[COUNTER_NAN], tally.nan);
  if (faults > 0u) atomicAdd(counters[COUNTER_FAULTS], faults);
  if (kClamp) countClamped(tally.clamped);
}
