// SPDX-License-Identifier: MIT
// What happens at one vertex of a path: light sampled and met, each weighed against the other (Veach & Guibas 1995).
#ifndef PATH_GLSL
#define PATH_GLSL
#extension GL_GOOGLE_include_directive : require
#include "camera.glsl"
#include "environment.glsl"
#include "light_tree.glsl"
#include "lights.glsl"
#include "mesh_light.glsl"
#include "random.glsl"
#include "shading.glsl"

struct Path {
  Ray ray;
  vec3 throughput;
  vec3 radiance;
  float pdf;        // of the ray's direction, per solid angle; 0 = camera ray or perfect mirror, no light sample rivals it
  vec3 absorption;  // 1/m, of the solids that the ray runs through
  uint bounce;
  uint index;       // of the sample
  float width;      // of the cone of rays around this one, for textures: metres where the ray starts,
  float spread;     // and more for every metre
  float compression;  // n^2 of the glass that the ray runs through: there radiance is as much greater
};

// A vertex as shading sees it.
struct Vertex {
  Surface surface;
  SurfaceMaterial material;
  Frame frame;  // around the shading normal on wo's side
  vec3 wo;      // local
  bool inside;  // wo lies on the inner side of the surface
  bool thin;    // a sheet, which has no inside to go to
  bool mesh;    // its shading normal need not be that of the facet
  uint primitive;
  uint triangle;  // of a mesh: its first row
  vec3 absorption;  // 1/m, on the way here
  uint seed, index, bounce;  // for this vertex' random numbers
};

// What a pixel's loop counts, beside its sum.
struct Tally {
  uint closestRays;
  uint shadowRays;
  uint nan;
  uint missing;
  float clamped;  // luminance cut off, nit
};

// Light that is sampled at the last vertex may also be met just behind it; both halves of the estimate are needed.
uint lastBounce() { return params.maxBounces + ((params.flags & TRACE_MET_LIGHTS) != 0u ? 1u : 0u); }

// Behind the last bounce, light is only met.
bool samplesLights(Path path) { return path.bounce <= params.maxBounces; }

bool ablated(uint flag) { return kAblation && (params.flags & flag) != 0u; }

SamplePair pairAt(uint seed, uint index, uint dimension) {
  if (ablated(TRACE_PCG_SAMPLES)) return pcgPair(seed, index, dimension);
  return samplePair(seed, index, dimension);
}

// Whether a facet of glass mirrors or lets pass at this bounce: a number of its own, as the pair has drawn the facet.
float facetNumber(uint seed, uint index, uint bounce) { return kTransmission ? pairAt(seed, index, 0x1001u + bounce).x : 0.0; }

// Pairs of the light samples at one vertex: `slot` counts them, the environment has the last.
SamplePair lightPair(Vertex v, uint slot) { return pairAt(v.seed, v.index, 0x2000u + v.bounce * 64u + slot); }

// Whether wi lies on the side of the facet on which the shading normal sees it. Where the two part, a reflection would
// leak through the facet, and what passes it would not.
bool keepsSide(Vertex v, vec3 wi, vec3 local) {
  bool below = (dot(v.surface.normal, wi) < 0.0) != v.inside;
  return !(kMeshes && v.mesh) || below == (local.z < 0.0);
}

// A ray that leaves the vertex along wi, which is local direction `local`.
Ray leaving(Vertex v, vec3 wi, vec3 local) {
  bool through = kTransmission && local.z < 0.0 && !v.thin;
  vec3 o = v.surface.p;
  if (kMeshes) o += v.surface.normal * (dot(v.surface.normal, wi) < 0.0 ? -v.surface.offset : v.surface.offset);
  return Ray(o, wi, v.primitive, v.inside != through);
}

// 1/m, along a ray that leaves in local direction `local`. Solids may lie within each other.
vec3 absorptionTowards(Vertex v, vec3 local) {
  vec3 beyond = v.inside ? max(v.absorption - v.material.absorption, vec3(0.0)) : v.absorption + v.material.absorption;
  return kTransmission && local.z < 0.0 && !v.thin ? beyond : v.absorption;
}

// The nearest hit of the path's ray, which decides about half transparent surfaces in its own way.
Hit nextHit(Path path, uint seed, Layout l) {
  seedAlpha(seed, path.index, 2u * path.bounce);
  return closestHit(path.ray, INFINITE, l);
}

// How many samples a light gets at a vertex, on average.
float samplesOfLight(uint light, vec3 p) {
  if (!kLightTree || params.lightCount <= params.lightSamples) return 1.0;
  return float(params.lightSamples) * lightChoiceProbability(p, light);
}

// What one light sample reflects to wo if nothing is in between; `samples` is how many the light gets.
vec3 unshadowedLight(LightSample s, float samples, Vertex v, Lobes lobes) {
  vec3 local = toLocal(v.frame, s.wi);
  BsdfValue value = evalBsdf(lobes, v.wo, local, lobeKinds());
  vec3 f = value.fCos * s.illuminance;
  if (kMetLights) {
    float weight = ablated(TRACE_NO_BSDF_HITS) ? 1.0 : powerHeuristic(s.pdf * samples, value.pdf);
    f *= s.pdf > 0.0 ? (ablated(TRACE_NO_LIGHT_SAMPLING) ? 0.0 : weight) : 1.0;
  }
  if (kLightTree) f /= samples;
  return keepsSide(v, s.wi, local) ? f : vec3(0.0);
}

// A ray to a light sample, and its length. Where it starts beside the surface of a mesh it is aimed anew: a shift as long as
// the gap that keeps the facet of a glowing mesh from shadowing itself would close that.
struct ShadowRay {
  Ray ray;
  ShadowEnd end;
};

ShadowRay shadowRay(LightSample s, Vertex v, vec3 local) {
  bool placed = kOnlyPoints || (s.pdf == 0.0 && s.distance < INFINITE);
  ShadowRay shadow = ShadowRay(leaving(v, s.wi, local), ShadowEnd(s.distance, s.place, placed));
  if (kMeshLights) {
    vec3 rest = (v.surface.p - shadow.ray.o) + s.wi * s.distance;
    float end = length(rest);
    bool shifted = v.surface.offset > 0.0 && s.distance < INFINITE && end > 0.0;
    shadow.ray.d = shifted ? rest / end : shadow.ray.d;
    shadow.end.t = shifted ? end : shadow.end.t;
  }
  return shadow;
}

// Less what is in between.
vec3 shadowedLight(LightSample s, vec3 f, Vertex v, inout Tally tally, Layout l) {
  bool needed = maxComponent(f) > 0.0;
  seedAlpha(v.seed, v.index, 2u * v.bounce + 1u);
  tally.shadowRays += needed ? 1u : 0u;
  vec3 local = toLocal(v.frame, s.wi);
  ShadowRay shadow = shadowRay(s, v, local);
  bool visible = needed && !occluded(shadow.ray, shadow.end, s.primitive, l);
  if (kAbsorption) f *= exp(-absorptionTowards(v, local) * s.distance);
  return visible ? f : vec3(0.0);
}

// Light that arrives straight from one light sample and is reflected to wo.
vec3 directLight(LightSample s, float samples, Vertex v, Lobes lobes, inout Tally tally, Layout l) {
  return shadowedLight(s, unshadowedLight(s, samples, v, lobes), v, tally, l);
}

LightSample lightSampleAt(LightRows light, Vertex v, uint slot) {
  SamplePair pair = SamplePair(0.5, 0.5);
  if (kAreaLights || kSuns) pair = lightPair(v, slot);
  LightSample s = sampleLight(light, v.surface.p, pair.x, pair.y);
  // A convex solid lights itself through its inside alone, whatever side of its surface rounding puts the point on.
  bool outwards = dot(v.surface.normal, s.wi) >= 0.0;
  if (isSolidLight(uint(light.a.w)) && v.primitive == s.primitive && outwards) s.illuminance = vec3(0.0);
  if (isMeshLight(light)) {
    s = sampleMeshLight(light, v.surface.p, pair.x, pair.y, primitiveLayout());
    // A point in the plane of the facet gives it nothing; rounding must not lift it above.
    bool level = abs(dot(v.surface.normal, s.wi)) * s.distance <= 4.0 * v.surface.offset;
    s.illuminance *= level ? 0.0 : 1.0;
  }
  return s;
}

// Baked lights are sampled, evaluated and tested step by step, all lights at each: a CPU then works on several chains of
// dependent operations at once.
struct BakedSamples {
  LightSample light[MAX_FIXED_LIGHTS];
};

BakedSamples sampleBakedLights(Vertex v) {
  BakedSamples samples;
  [[unroll]] for (uint i = 0u; i < kFixedLights; ++i) samples.light[i] = lightSampleAt(bakedLights[i], v, i);
  return samples;
}

vec3 lightFromBakedLights(BakedSamples samples, bool lit, Vertex v, Lobes lobes, inout Tally tally, Layout l) {
  vec3 sum = vec3(0.0);
  vec3 unshadowed[MAX_FIXED_LIGHTS];
  [[unroll]] for (uint i = 0u; i < kFixedLights; ++i) unshadowed[i] = unshadowedLight(samples.light[i], 1.0, v, lobes);
  [[unroll]] for (uint i = 0u; i < kFixedLights; ++i) {
    vec3 f = lit ? unshadowed[i] : vec3(0.0);
    sum += shadowedLight(samples.light[i], f, v, tally, l);
  }
  return sum;
}

// All lights while they are few; else some, chosen for this point.
vec3 lightFromLights(Vertex v, Lobes lobes, inout Tally tally, Layout l) {
  vec3 sum = vec3(0.0);
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
vec3 emittedLight(Vertex v, Path path) {
  SurfaceMaterial material = v.material;
  bool hidden = v.inside && (material.bits & MATERIAL_ONE_SIDED) != 0u;
  float weight = hidden ? 0.0 : 1.0;
  if (kAreaLights) {
    uint light = min(material.light, max(params.lightCount, 1u) - 1u);
    LightRows rows = fetchLight(light);
    float pdf = lightPdf(rows, path.ray.o, path.ray.d);
    if (isMeshLight(rows)) pdf = meshLightPdf(rows, v.triangle, path.ray.o, path.ray.d, primitiveLayout());
    pdf *= samplesOfLight(light, path.ray.o);
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
      float pdf = sunPdf(sun) * samplesOfLight(i, path.ray.o);
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

// `hit` has a primitive.
Vertex vertexAt(Hit hit, Path path, uint seed, Layout l) {
  Vertex v;
  v.surface = surfaceAt(path.ray, hit, l);
  float jitter = kTextures ? sampleIndependent(seed, path.index, 0x20000u + path.bounce) : 0.0;
  Shading shading = shadingAt(v.surface, hit, path.ray.d, path.width + path.spread * hit.t, path.pdf > 0.0, jitter, l);
  v.material = shading.material;
  // A ray that left to its own solid's inside meets it from there, even where an edge or a graze blurs the sign.
  bool back = path.ray.self == hit.primitive && path.ray.selfInside && hit.primitive < l.instance;
  v.inside = back || dot(v.surface.normal, path.ray.d) > 0.0;
  vec3 normal = v.inside ? -v.surface.normal : v.surface.normal;
  v.mesh = kMeshes && hit.primitive >= l.instance;
  if (v.mesh) normal = bentNormal(v.inside ? -shading.normal : shading.normal, normal, -path.ray.d);
  v.frame = frameAround(normal);
  v.wo = toLocal(v.frame, -path.ray.d);
  v.wo.z = clamp(v.wo.z, 1e-7, 1.0);
  v.thin = (hit.primitive >= l.rect && hit.primitive < l.cylinder) || (kMeshes && (v.material.bits & MATERIAL_THIN) != 0u);
  v.primitive = hit.primitive;
  v.triangle = hit.triangle;
  v.seed = seed;
  v.index = path.index;
  v.bounce = path.bounce;
  v.absorption = path.absorption;
  return v;
}

// Russian roulette, after the third bounce.
bool roulettePlayed(Path path) { return kRoulette && (params.flags & TRACE_RUSSIAN_ROULETTE) != 0u && path.bounce >= 3u; }

// Chance to go on, by what the path would carry outside of all glass: inside, its throughput is less by what radiance will
// gain, and paths would be lost that bring as much light as any (Pharr, Jakob & Humphreys, PBRT 4th ed., 13.4).
float survivalOf(Path path) {
  float carried = maxComponent(path.throughput) * (kTransmission ? path.compression : 1.0);
  return roulettePlayed(path) ? min(1.0, carried) : 1.0;
}

// The ray that goes on from a vertex along a sampled direction; eta: that of its lobes. Its cone is an eighth as wide as the
// lobe: textures that are seen in a mirror stay sharp, those that light a rough surface are looked up coarsely (after
// Akenine-Moller et al., Improved Shader and Texture Level of Detail Using Ray Cones, JCGT 10(1), 2021).
void goOn(inout Path path, float t, Vertex v, float eta, BsdfSample next) {
  vec3 wi = toWorld(v.frame, next.wi);
  path.ray = leaving(v, wi, next.wi);
  path.throughput *= next.weight;
  if (kMeshes) path.throughput *= keepsSide(v, wi, next.wi) ? 1.0 : 0.0;
  if (kTransmission) path.compression *= next.wi.z < 0.0 && !v.thin ? eta * eta : 1.0;
  path.pdf = next.pdf;
  path.bounce += 1u;
  if (kTextures) {
    path.width += path.spread * t;
    path.spread = max(path.spread, next.pdf > 0.0 ? 0.125 * inversesqrt(next.pdf) : 0.0);
  }
  if (kAbsorption) path.absorption = absorptionTowards(v, next.wi);
}

Path cameraPath(CameraRows camera, uvec2 pixel, SamplePair pair, uint seed, uint index) {
  SamplePair lens = SamplePair(0.0, 0.0);
  if (kLens) lens = pairAt(seed, index, 0x1000u);
  CameraRay seen = filteredCameraRay(camera, pixel, pair.x, pair.y, lens.x, lens.y);
  Ray ray = Ray(seen.o, seen.d, NO_PRIMITIVE, false);
  // Half a pixel: samples average what textures show within it.
  float halfPixel = 0.5 * params.pixelScale;
  bool parallel = kOrthographic && camera.forward.w > 0.0;
  return Path(ray, vec3(1.0), vec3(0.0), 0.0, camera.absorption, 0u, index, parallel ? halfPixel : 0.0, parallel ? 0.0 : halfPixel, 1.0);
}

#endif
