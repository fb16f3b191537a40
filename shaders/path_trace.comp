#version 460
// SPDX-License-Identifier: MIT
// Adds samples [sampleBegin, sampleEnd) to every pixel of rows [rowBegin, rowEnd): paths with next-event estimation.
// One loop level: each turn traces one path segment, and a path that ended makes room for the next sample at once.
// The order of additions per pixel is that of the sample index, so any split into dispatches gives the same bytes.
#extension GL_GOOGLE_include_directive : require
#include "camera.glsl"
#include "film.glsl"
#include "lights.glsl"
#include "random.glsl"
#include "surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

struct Path {
  Ray ray;
  vec3 throughput;
  vec3 radiance;
  uint bounce;
};

struct Counts {
  uint closest, shadow, nan, faults;
};

// The half-buffer and the index within its own sequence of a sample.
uint halfOf(uint s) { return (params.flags & TRACE_ERROR_METER) != 0u ? s & 1u : 0u; }
uint indexOf(uint s) { return (params.flags & TRACE_ERROR_METER) != 0u ? s >> 1 : s; }

// Light from light number `i` of this vertex's samples, unoccluded part of the estimate, times its shadow ray.
vec3 directLight(LightRows light, Surface surface, Frame frame, Lobes lobes, vec3 wo, float chance, Path path,
                 float weight, bool inside, inout Counts counts, Layout l) {
  LightSample s = sampleLight(light, surface.p);
  vec3 wi = toLocal(frame, s.wi);
  vec3 f = evalBsdf(lobes, wo, wi, chance, kDiffuse, kGlossy).fCos * s.illuminance * path.throughput * weight;
  bool needed = maxComponent(f) > 0.0;
  counts.shadow += needed ? 1u : 0u;
  if (!needed) return vec3(0.0);
  Ray shadow = Ray(surface.p, s.wi, path.ray.self, inside);
  return occluded(shadow, s.distance, l) ? vec3(0.0) : f;
}

// All lights while they are few; else one per stratum of the list, each standing for its stratum.
vec3 allDirectLight(Surface surface, Frame frame, Lobes lobes, vec3 wo, float chance, Path path, bool inside,
                    uint pixelSeed, uint index, inout Counts counts, Layout l) {
  vec3 sum = vec3(0.0);
  if (kFixedLights > 0u) {
    [[unroll]] for (uint i = 0u; i < kFixedLights; ++i)
      sum += directLight(fetchLight(i), surface, frame, lobes, wo, chance, path, 1.0, inside, counts, l);
    return sum;
  }
  uint total = params.lightCount;
  uint samples = min(total, params.lightSamples);
  float perSample = float(total) / float(max(samples, 1u));
  float u = total > samples ? sampleIndependent(pixelSeed, index, 0x10000u + path.bounce) : 0.0;
  for (uint i = 0u; i < samples; ++i) {
    uint light = min(uint((float(i) + u) * perSample), total - 1u);
    sum += directLight(fetchLight(light), surface, frame, lobes, wo, chance, path, perSample, inside, counts, l);
  }
  return sum;
}

// Pixel order interleaved by rows of groups: some drivers give each thread a fixed half of the groups.
uvec2 pixelOfInvocation() {
  uint groups = gl_NumWorkGroups.y;
  uint firstHalf = (groups + 1u) / 2u;
  uint g = gl_WorkGroupID.y;
  uint row = g < firstHalf ? 2u * g : 2u * (g - firstHalf) + 1u;
  return uvec2(gl_GlobalInvocationID.x, params.rowBegin + row * gl_WorkGroupSize.y + gl_LocalInvocationID.y);
}

void main() {
  uvec2 pixel = pixelOfInvocation();
  if (pixel.x >= params.width || pixel.y >= params.rowEnd) return;
  uint at = pixel.y * params.width + pixel.x;
  Layout l = primitiveLayout();
  CameraRows camera = fetchCamera();
  loadBakedPrimitives();
  Compensated totalA = Compensated(sumA[at].xyz, carryA[at].xyz);
  Compensated totalB = Compensated(sumB[at].xyz, carryB[at].xyz);
  Counts counts = Counts(0u, 0u, 0u, 0u);

  // Start the first path.
  uint s = params.sampleBegin;
  uint pixelSeed = pixelSeedOf(pixel.x, pixel.y, halfOf(s), params.seed);
  SamplePair pair = samplePair(pixelSeed, indexOf(s), 0u);
  Path path = Path(Ray(vec3(0.0), cameraDirection(camera, pixel, pair.x, pair.y), NO_PRIMITIVE, false), vec3(1.0),
                   vec3(0.0), 0u);

  uint turns = (params.sampleEnd - params.sampleBegin) * (params.maxBounces + 1u);
  for (uint turn = 0u; turn < turns && s < params.sampleEnd; ++turn) {
    // Find the next vertex.
    Hit hit = closestHit(path.ray, INFINITE, l);
    counts.closest += 1u;
    bool ended = hit.primitive == NO_PRIMITIVE;
    uint primitive = min(hit.primitive, l.end - 1u);
    Surface surface = surfaceAt(path.ray, Hit(hit.t, primitive), l);
    SurfaceMaterial material = fetchMaterial(primitive);
    bool inside = dot(surface.normal, path.ray.d) > 0.0;
    Frame frame = frameAround(inside ? -surface.normal : surface.normal);
    vec3 wo = toLocal(frame, -path.ray.d);
    wo.z = max(wo.z, 1e-7);
    float chance = kDiffuse ? (kGlossy || kMirror ? specularChance(material.lobes, wo.z) : 0.0) : 1.0;
    path.ray = Ray(surface.p, path.ray.d, primitive, inside);

    if (!ended) {
      // Add what the surface emits, and what the lights send it.
      counts.faults += missingFeatures(material.features) != 0u ? 1u : 0u;
      if (kEmission) path.radiance += path.throughput * material.emission;
      if (kLights)
        path.radiance += allDirectLight(surface, frame, material.lobes, wo, chance, path, inside, pixelSeed,
                                        indexOf(s), counts, l);
    }

    // Decide whether the path ends: bounce limit, then Russian roulette after the third bounce.
    ended = ended || path.bounce >= params.maxBounces;
    float survival = min(1.0, maxComponent(path.throughput));
    if ((params.flags & TRACE_RUSSIAN_ROULETTE) != 0u && path.bounce >= 3u) {
      ended = ended || sampleIndependent(pixelSeed, indexOf(s), path.bounce) >= survival;
      path.throughput /= max(survival, 1e-30);
    }

    // Commit a finished sample and take the next one.
    if (ended) {
      bool finite = isFiniteVec(path.radiance);
      counts.nan += finite ? 0u : 1u;
      vec3 value = finite ? path.radiance : vec3(0.0);
      if (halfOf(s) == 0u) totalA = compensatedAdd(totalA, value);
      else totalB = compensatedAdd(totalB, value);
      s += 1u;
      pixelSeed = pixelSeedOf(pixel.x, pixel.y, halfOf(s), params.seed);
    }
    path.bounce = ended ? 0u : path.bounce + 1u;

    // Draw one pair: for the camera of a new path, or for the next direction of this one.
    pair = samplePair(pixelSeed, indexOf(s), path.bounce);
    BsdfSample next = sampleBsdf(material.lobes, wo, pair.x, pair.y, chance, kDiffuse, kGlossy, kMirror);
    vec3 direction = ended ? cameraDirection(camera, pixel, pair.x, pair.y) : toWorld(frame, next.wi);
    path.ray = Ray(ended ? vec3(0.0) : path.ray.o, direction, ended ? NO_PRIMITIVE : primitive, inside);
    path.throughput = ended ? vec3(1.0) : path.throughput * next.weight;
    path.radiance = ended ? vec3(0.0) : path.radiance;
  }

  // A sample that the loop budget cut off is a fault, never a silently darker pixel.
  counts.faults += params.sampleEnd - min(s, params.sampleEnd);
  sumA[at] = vec4(totalA.sum, sumA[at].w + float(counts.closest));
  carryA[at] = vec4(totalA.carry, carryA[at].w + float(counts.nan));
  sumB[at] = vec4(totalB.sum, sumB[at].w + float(counts.shadow));
  carryB[at] = vec4(totalB.carry, carryB[at].w + float(counts.faults));
}
