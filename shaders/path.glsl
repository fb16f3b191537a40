// SPDX-License-Identifier: MIT
// What happens at one vertex of a path: light sampled and met, each weighed against the other (Veach & Guibas 1995).
#ifndef PATH_GLSL
#define PATH_GLSL
#extension GL_GOOGLE_include_directive : require
#include "camera.glsl"
#include "environment.glsl"
#include "light_tree.glsl"
#include "lights.glsl"
#include "material.glsl"
#include "random.glsl"
#include "surface.glsl"

struct Path {
  Ray ray;
  vec3 throughput;
  vec3 radiance;
  float pdf;        // of the ray's direction, per solid angle; 0 = camera ray or perfect mirror, no light sample rivals it
  vec3 absorption;  // 1/m, of the solid that the ray runs through
  uint bounce;
  uint index;       // of the sample
};

// A vertex as shading sees it.
struct Vertex {
  Surface surface;
  Frame frame;  // around the normal on wo's side
  vec3 wo;      // local
  bool inside;  // wo lies on the inner side of the surface
  bool thin;    // a sheet, which has no inside to go to
  uint primitive;
  uint seed, index, bounce;  // for this vertex' random numbers
};

// What a pixel's loop counts, beside its sum.
struct Tally {
  uint closestRays;
  uint shadowRays;
  uint nan;
  uint missing;
  float clamped;  // nit cut off
};

// Light that is sampled at the last vertex may also be met just behind it; both halves of the estimate are needed.
uint lastBounce() { return params.maxBounces + ((params.flags & TRACE_MET_LIGHTS) != 0u ? 1u : 0u); }

// Behind the last bounce, light is only met.
bool samplesLights(Path path) { return path.bounce <= params.maxBounces; }

bool ablated(uint flag) { return kAblation && (params.flags & flag) != 0u; }

SamplePair pairAt(uint seed, uint index, uint dimension) {
  if (ablated(TRACE_INDEPENDENT_SAMPLES))
    return SamplePair(sampleIndependent(seed, index, 2u * dimension + 0x40000u), sampleIndependent(seed, index, 2u * dimension + 0x40001u));
  return samplePair(seed, index, dimension);
}

// Pairs of the light samples at one vertex: `slot` counts them, the environment has the last.
SamplePair lightPair(Vertex v, uint slot) { return pairAt(v.seed, v.index, 0x2000u + v.bounce * 64u + slot); }

// A ray that leaves the vertex along wi, which is local direction `local`.
Ray leaving(Vertex v, vec3 wi, vec3 local) {
  bool through = kTransmission && local.z < 0.0 && !v.thin;
  return Ray(v.surface.p, wi, v.primitive, v.inside != through);
}

// How many samples a light gets at a vertex, on average.
float samplesOfLight(uint light, vec3 p) {
  if (!kLightTree || params.lightCount <= params.lightSamples) return 1.0;
  return float(params.lightSamples) * lightChoiceProbability(p, light);
}

// Light that arrives straight from one light sample and is reflected to wo; `samples` is how many the light gets.
vec3 directLight(LightSample s, float samples, Vertex v, Lobes lobes, inout Tally tally, Layout l) {
  vec3 local = toLocal(v.frame, s.wi);
  BsdfValue value = evalBsdf(lobes, v.wo, local, lobeKinds());
  vec3 f = value.fCos * s.illuminance;
  if (kMetLights) {
    float weight = ablated(TRACE_NO_BSDF_HITS) ? 1.0 : powerHeuristic(s.pdf * samples, value.pdf);
    f *= s.pdf > 0.0 ? (ablated(TRACE_NO_LIGHT_SAMPLING) ? 0.0 : weight) : 1.0;
  }
  if (kLightTree) f /= samples;
  bool needed = maxComponent(f) > 0.0;
  tally.shadowRays += needed ? 1u : 0u;
  bool visible = needed && !occluded(leaving(v, s.wi, local), s.distance, s.primitive, l);
  return visible ? f : vec3(0.0);
}

LightSample lightSampleAt(LightRows light, Vertex v, uint slot) {
  SamplePair pair = SamplePair(0.5, 0.5);
  if (kAreaLights || kSuns) pair = lightPair(v, slot);
  return sampleLight(light, v.surface.p, pair.x, pair.y);
}

// All lights while they are few; else some, chosen for this point.
vec3 lightFromLights(Vertex v, Lobes lobes, inout Tally tally, Layout l) {
  vec3 sum = vec3(0.0);
  if (kFixedLights > 0u) {
    [[unroll]] for (uint i = 0u; i < kFixedLights; ++i)
      sum += directLight(lightSampleAt(bakedLights[i], v, i), 1.0, v, lobes, tally, l);
    return sum;
  }
  uint samples = min(params.lightCount, params.lightSamples);
  bool all = !kLightTree || params.lightCount <= params.lightSamples;
  float u = kLightTree ? sampleIndependent(v.seed, v.index, 0x10000u + v.bounce) : 0.0;
  for (uint i = 0u; i < samples; ++i) {
    LightChoice choice = LightChoice(i, 1.0);
    if (kLightTree) {
      LightChoice chosen = chooseLight(v.surface.p, (float(i) + u) / float(samples));
      chosen.probability *= float(samples);
      if (!all) choice = chosen;
    }
    sum += directLight(lightSampleAt(fetchLight(choice.light), v, i), choice.probability, v, lobes, tally, l);
  }
  return sum;
}

vec3 lightFromEnvironment(Vertex v, Lobes lobes, inout Tally tally, Layout l) {
  SamplePair pair = lightPair(v, 63u);
  LightSample s = sampleEnvironment(pair.x, pair.y);
  vec3 sum = directLight(s, 1.0, v, lobes, tally, l);
  return hasEnvironment() ? sum : vec3(0.0);
}

// Weight of light that a path met by itself, which a light sample of density `lightPdf` could have found too.
float metWeight(float pathPdf, float lightPdf) {
  if (ablated(TRACE_NO_LIGHT_SAMPLING)) return 1.0;
  if (ablated(TRACE_NO_BSDF_HITS)) return pathPdf > 0.0 && lightPdf > 0.0 ? 0.0 : 1.0;
  return pathPdf > 0.0 ? powerHeuristic(pathPdf, lightPdf) : 1.0;
}

// Radiance of the surface that the path met.
vec3 emittedLight(SurfaceMaterial material, Vertex v, Path path) {
  bool hidden = v.inside && (material.bits & MATERIAL_ONE_SIDED) != 0u;
  float weight = hidden ? 0.0 : 1.0;
  if (kAreaLights) {
    uint light = min(material.light, max(params.lightCount, 1u) - 1u);
    float pdf = lightPdf(fetchLight(light), path.ray.o, path.ray.d) * samplesOfLight(light, path.ray.o);
    weight *= material.light == NO_LIGHT ? 1.0 : metWeight(path.pdf, pdf);
  }
  return material.emission * weight;
}

// Radiance of the sky, for a path that left the scene.
vec3 skyLight(Path path) {
  vec3 sum = vec3(0.0);
  if (kEnvironment) {
    vec3 radiance = environmentRadiance(path.ray.d) * metWeight(path.pdf, environmentPdf(path.ray.d));
    sum = hasEnvironment() ? radiance : sum;
  }
  if (kSuns)
    for (uint i = 0u; i < params.sunCount; ++i) {
      LightRows sun = fetchLight(i);
      float pdf = lightPdf(sun, path.ray.o, path.ray.d) * samplesOfLight(i, path.ray.o);
      sum += sunRadiance(sun, path.ray.d) * metWeight(path.pdf, pdf);
    }
  return sum;
}

// Adds light that took `bounces` to the path's sample; with clamping on, what is too bright after more than one is cut
// and tallied.
void addLight(inout Path path, inout Tally tally, vec3 light, uint bounces) {
  vec3 contribution = path.throughput * light;
  if (kClamp) {
    float brightest = maxComponent(contribution);
    bool cut = params.clampRadiance > 0.0 && bounces > 1u && brightest > params.clampRadiance;
    float kept = cut ? params.clampRadiance / brightest : 1.0;
    tally.clamped += cut ? luminance(contribution) * (1.0 - kept) : 0.0;
    contribution *= kept;
  }
  path.radiance += contribution;
}

Vertex vertexAt(Surface surface, Path path, uint primitive, uint seed, Layout l) {
  Vertex v;
  v.surface = surface;
  // A ray that left to its own solid's inside meets it from there, even where an edge or a graze blurs the sign.
  bool back = path.ray.self == primitive && path.ray.selfInside;
  v.inside = back || dot(surface.normal, path.ray.d) > 0.0;
  v.frame = frameAround(v.inside ? -surface.normal : surface.normal);
  v.wo = toLocal(v.frame, -path.ray.d);
  v.wo.z = clamp(v.wo.z, 1e-7, 1.0);
  v.thin = primitive >= l.rect && primitive < l.cylinder;
  v.primitive = primitive;
  v.seed = seed;
  v.index = path.index;
  v.bounce = path.bounce;
  return v;
}

Path cameraPath(CameraRows camera, uvec2 pixel, SamplePair pair, uint seed, uint index) {
  SamplePair lens = SamplePair(0.0, 0.0);
  if (kLens) lens = pairAt(seed, index, 0x1000u);
  CameraRay seen = filteredCameraRay(camera, pixel, pair.x, pair.y, lens.x, lens.y);
  Ray ray = Ray(seen.o, seen.d, NO_PRIMITIVE, false);
  return Path(ray, vec3(1.0), vec3(0.0), 0.0, vec3(0.0), 0u, index);
}

#endif
