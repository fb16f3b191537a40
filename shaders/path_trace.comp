#version 460
// SPDX-License-Identifier: MIT
// Adds samples [sampleBegin, sampleEnd) of one half-buffer to every pixel of rows [rowBegin, rowEnd): paths with
// next-event estimation. One loop level: each turn traces one path segment, and a path that ended makes room for the
// next sample at once. Additions follow the sample index, so any split into dispatches gives the same bytes.
#extension GL_GOOGLE_include_directive : require
#include "camera.glsl"
#include "lights.glsl"
#include "random.glsl"
#include "surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// The half-buffer of this dispatch (see film.glsl), and what must stay 0.
layout(set = 0, binding = 1) buffer Sum { vec4 filmSum[]; };
layout(set = 0, binding = 2) buffer Carry { vec4 filmCarry[]; };
layout(set = 0, binding = 5) buffer Counters { uint counters[COUNTERS]; };

struct Path {
  Ray ray;
  vec3 throughput;
  vec3 radiance;
  uint bounce;
  uint index;  // of the sample
};

// A vertex as shading sees it.
struct Vertex {
  Surface surface;
  Frame frame;     // around the normal on wo's side
  vec3 wo;         // local
  bool inside;     // wo lies on the inner side of the surface
  float chance;    // to sample the specular lobe
};

// Light that arrives straight from one light and is reflected to wo. Counts the shadow rays that matter.
vec3 directLight(LightRows light, Vertex v, Lobes lobes, uint primitive, inout uint shadowRays, Layout l) {
  LightSample s = sampleLight(light, v.surface.p);
  vec3 f = evalBsdf(lobes, v.wo, toLocal(v.frame, s.wi), v.chance, kDiffuse, kGlossy).fCos * s.illuminance;
  bool needed = maxComponent(f) > 0.0;
  shadowRays += needed ? 1u : 0u;
  bool visible = needed && !occluded(Ray(v.surface.p, s.wi, primitive, v.inside), s.distance, l);
  return visible ? f : vec3(0.0);
}

// All lights while they are few; else one per stratum of the list, each standing for its stratum.
vec3 allDirectLight(Vertex v, Lobes lobes, uint primitive, float u, inout uint shadowRays, Layout l) {
  vec3 sum = vec3(0.0);
  if (kFixedLights > 0u) {
    [[unroll]] for (uint i = 0u; i < kFixedLights; ++i)
      sum += directLight(bakedLights[i], v, lobes, primitive, shadowRays, l);
    return sum;
  }
  uint samples = min(params.lightCount, params.lightSamples);
  float perSample = float(params.lightCount) / float(max(samples, 1u));
  for (uint i = 0u; i < samples; ++i) {
    uint light = min(uint((float(i) + u) * perSample), params.lightCount - 1u);
    sum += directLight(fetchLight(light), v, lobes, primitive, shadowRays, l) * perSample;
  }
  return sum;
}

Vertex vertexAt(Surface surface, Lobes lobes, vec3 d) {
  Vertex v;
  v.surface = surface;
  v.inside = dot(surface.normal, d) > 0.0;
  v.frame = frameAround(v.inside ? -surface.normal : surface.normal);
  v.wo = toLocal(v.frame, -d);
  v.wo.z = clamp(v.wo.z, 1e-7, 1.0);
  v.chance = kDiffuse ? (kGlossy || kMirror ? specularChance(lobes, v.wo.z) : 0.0) : 1.0;
  return v;
}

Path cameraPath(CameraRows camera, uvec2 pixel, SamplePair pair, uint index) {
  Ray ray = Ray(vec3(0.0), cameraDirection(camera, pixel, pair.x, pair.y), NO_PRIMITIVE, false);
  return Path(ray, vec3(1.0), vec3(0.0), 0u, index);
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
  loadBakedLights();
  vec4 sum = filmSum[at];
  vec4 carry = filmCarry[at];
  Compensated total = Compensated(sum.xyz, carry.xyz);
  uint closestRays = 0u;
  uint shadowRays = 0u;
  uint nan = 0u;
  uint missing = 0u;

  uint pixelSeed = pixelSeedOf(pixel.x, pixel.y, params.flags & TRACE_HALF_B, params.seed);
  bool roulette = (params.flags & TRACE_RUSSIAN_ROULETTE) != 0u;
  Path path = cameraPath(camera, pixel, samplePair(pixelSeed, params.sampleBegin, 0u), params.sampleBegin);

  // Every turn lengthens a path or ends it, so the turns are bounded by samples * (maxBounces + 1).
  while (path.index < params.sampleEnd) {
    // Find the next vertex.
    Hit hit = closestHit(path.ray, INFINITE, l);
    closestRays += 1u;
    bool ended = hit.primitive == NO_PRIMITIVE;
    uint primitive = min(hit.primitive, l.end - 1u);
    SurfaceMaterial material = fetchMaterial(primitive);
    Vertex v = vertexAt(surfaceAt(path.ray, Hit(hit.t, primitive), l), material.lobes, path.ray.d);

    // Add what the surface emits, and what the lights send it.
    if (!ended) {
      missing |= missingFeatures(material.features);
      if (kEmission) path.radiance += path.throughput * material.emission;
      if (kLights) {
        float u = params.lightCount > params.lightSamples
                      ? sampleIndependent(pixelSeed, path.index, 0x10000u + path.bounce)
                      : 0.0;
        path.radiance += path.throughput * allDirectLight(v, material.lobes, primitive, u, shadowRays, l);
      }
    }

    // Decide whether the path ends: bounce limit, then Russian roulette after the third bounce.
    ended = ended || path.bounce >= params.maxBounces;
    if (roulette && path.bounce >= 3u) {
      float survival = min(1.0, maxComponent(path.throughput));
      ended = ended || sampleIndependent(pixelSeed, path.index, path.bounce) >= survival;
      path.throughput /= max(survival, 1e-30);
    }

    // Draw one pair: for the camera of the next path, or for the next direction of this one.
    uint index = ended ? path.index + 1u : path.index;
    SamplePair pair = samplePair(pixelSeed, index, ended ? 0u : path.bounce + 1u);
    BsdfSample next = sampleBsdf(material.lobes, v.wo, pair.x, pair.y, v.chance, kDiffuse, kGlossy, kMirror);
    path.ray = Ray(v.surface.p, toWorld(v.frame, next.wi), primitive, v.inside);
    path.throughput *= next.weight;
    path.bounce += 1u;

    // Commit a finished sample and start the next one.
    if (ended) {
      bool finite = isFiniteVec(path.radiance);
      nan += finite ? 0u : 1u;
      total = compensatedAdd(total, finite ? path.radiance : vec3(0.0));
      path = cameraPath(camera, pixel, pair, index);
    }
  }

  filmSum[at] = vec4(total.sum, sum.w + float(closestRays));
  filmCarry[at] = vec4(total.carry, carry.w + float(shadowRays));
  // A sample that the loop budget cut off is a fault, never a silently darker pixel.
  uint faults = (params.sampleEnd - min(path.index, params.sampleEnd)) + (missing != 0u ? 1u : 0u);
  if (nan > 0u) atomicAdd(counters[COUNTER_NAN], nan);
  if (faults > 0u) atomicAdd(counters[COUNTER_FAULTS], faults);
}
