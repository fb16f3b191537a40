// SPDX-License-Identifier: MIT
// One sample of one pixel with everything written down: the turns of path_trace.comp's loop as stages, each of which
// can be repeated from its recorded inputs. Who includes this file declares `vec4 recordRows[]` first, filled with 0.
#ifndef PATH_RECORD_GLSL
#define PATH_RECORD_GLSL
#include "path.glsl"

// Rows of a path: number of vertices, -, -, - | radiance, -; then its vertices. Rows of a vertex:
//   state    origin, self | direction, 1 = to the inside of self | throughput, pdf | absorption, bounce | radiance, index
//            cone: width, spread, -, -
//   hit      t, primitive or -1, bits: triangle, -
//   surface  point, 1 = inside | shading normal on wo's side, - | wo, -
//   met      light that the path met here, -
//   next     wi, pdf | weight, 1 = the path ended | throughput behind it, -
//   lights   slots of: 1 = used, light or -1, its number of samples, - | wi, distance | illuminance, pdf | f cos, pdf |
//            reflected light, primitive or -1;   the last slot is the environment
const uint RECORD_HEADER = 2u;
const uint RECORD_STATE = 0u;
const uint RECORD_HIT = 6u;
const uint RECORD_SURFACE = 7u;
const uint RECORD_MET = 10u;
const uint RECORD_NEXT = 11u;
const uint RECORD_LIGHTS = 14u;
const uint RECORD_LIGHT_ROWS = 5u;
const uint RECORD_SKY = MAX_LIGHT_SAMPLES;  // slot
const uint RECORD_VERTEX_ROWS = RECORD_LIGHTS + (MAX_LIGHT_SAMPLES + 1u) * RECORD_LIGHT_ROWS;

// Indices as numbers, exact up to 2^24.
float indexNumber(uint index) { return index == NO_PRIMITIVE ? -1.0 : float(index); }
float truth(bool b) { return b ? 1.0 : 0.0; }

uint pathSeed(uvec2 pixel) { return pixelSeedOf(pixel.x, pixel.y, params.flags & TRACE_HALF_B, params.seed); }

uint lightSlots() { return kLights ? min(params.lightCount, params.lightSamples) : 0u; }

// Which light a slot tries, and how many samples it gets on average.
LightChoice lightOfSlot(Vertex v, uint slot) {
  uint samples = lightSlots();
  LightChoice choice = LightChoice(slot, 1.0);
  if (kLightTree && params.lightCount > params.lightSamples) {
    float u = sampleIndependent(v.seed, v.index, 0x10000u + v.bounce);
    choice = chooseLight(v.surface.p, (float(slot) + u) / float(samples));
    choice.probability *= float(samples);
  }
  return choice;
}

LightSample sampleOfSlot(Vertex v, uint slot, LightChoice choice) {
  SamplePair pair = lightPair(v, 63u);
  LightSample s = LightSample(vec3(0.0), 0.0, vec3(0.0), 0.0, NO_PRIMITIVE, vec3(0.0));
  if (slot < RECORD_SKY) s = lightSampleAt(fetchLight(choice.light), v, slot);
  else if (kSampledSky) s = sampleEnvironment(pair.x, pair.y);
  return s;
}

Lobes lobesOf(Vertex v) { return lobesAt(v.material, v.primitive, v.wo.z, v.inside, v.thin); }

BsdfValue bsdfTowards(Vertex v, vec3 wi) { return evalBsdf(lobesOf(v), v.wo, toLocal(v.frame, wi), lobeKinds()); }

vec3 reflectedLight(Vertex v, LightChoice choice, LightSample s, inout Tally tally, Layout l) {
  return directLight(s, choice.probability, v, lobesOf(v), tally, l);
}

BsdfSample nextDirection(Vertex v) {
  SamplePair pair = pairAt(v.seed, v.index, v.bounce + 1u);
  return sampleBsdf(lobesOf(v), v.wo, pair.x, pair.y, facetNumber(v.seed, v.index, v.bounce), lobeKinds());
}

// Less what is absorbed on a way of t.
Path arrived(Path path, float t) {
  if (kAbsorption) path.throughput *= exp(-path.absorption * t);
  return path;
}

// Light that the path met by itself: of a surface, or of the sky when it left the scene.
vec3 metLight(Path path, Vertex v, bool left) {
  vec3 light = vec3(0.0);
  if (left) {
    if (kEnvironment || kSuns) light = skyLight(path);
  } else if (kEmission) light = emittedLight(v, path);
  return light;
}

bool endsAt(Path path, Vertex v, bool left) {
  bool lost = roulettePlayed(path) && sampleIndependent(v.seed, path.index, path.bounce) >= survivalOf(path);
  return left || maxComponent(path.throughput) <= 0.0 || path.bounce >= lastBounce() || lost;
}

Path continued(Path path, float t, Vertex v, BsdfSample next) {
  if (roulettePlayed(path)) path.throughput /= max(survivalOf(path), 1e-30);
  goOn(path, t, v, lobesOf(v).eta, next);
  return path;
}

void recordState(uint at, Path path) {
  recordRows[at] = vec4(path.ray.o, indexNumber(path.ray.self));
  recordRows[at + 1u] = vec4(path.ray.d, truth(path.ray.selfInside));
  recordRows[at + 2u] = vec4(path.throughput, path.pdf);
  recordRows[at + 3u] = vec4(path.absorption, float(path.bounce));
  recordRows[at + 4u] = vec4(path.radiance, float(path.index));
  recordRows[at + 5u] = vec4(path.width, path.spread, path.compression, 0.0);
}

void recordSurface(uint at, Vertex v) {
  recordRows[at] = vec4(v.surface.p, truth(v.inside));
  recordRows[at + 1u] = vec4(v.frame.n, 0.0);
  recordRows[at + 2u] = vec4(v.wo, 0.0);
}

// Returns the light that the slot reflects along the path.
vec3 recordSlot(uint at, uint slot, Vertex v, inout Tally tally, Layout l) {
  LightChoice choice = LightChoice(NO_LIGHT, 1.0);
  if (slot < RECORD_SKY) choice = lightOfSlot(v, slot);
  LightSample s = sampleOfSlot(v, slot, choice);
  BsdfValue value = bsdfTowards(v, s.wi);
  vec3 light = reflectedLight(v, choice, s, tally, l);
  uint row = at + slot * RECORD_LIGHT_ROWS;
  recordRows[row] = vec4(1.0, indexNumber(choice.light), choice.probability, 0.0);
  recordRows[row + 1u] = vec4(s.wi, s.distance);
  recordRows[row + 2u] = vec4(s.illuminance, s.pdf);
  recordRows[row + 3u] = vec4(value.fCos, value.pdf);
  recordRows[row + 4u] = vec4(light, indexNumber(s.primitive));
  return light;
}

vec3 recordLights(uint at, Vertex v, inout Tally tally, Layout l) {
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < lightSlots(); ++i) sum += recordSlot(at, i, v, tally, l);
  if (hasEnvironment()) sum += recordSlot(at, RECORD_SKY, v, tally, l);
  return sum;
}

// The path of sample params.sampleBegin through `pixel`, written to the rows from `first` on.
void recordPath(uint first, uvec2 pixel) {
  Layout l = primitiveLayout();
  uint seed = pathSeed(pixel);
  Path path = cameraPath(fetchCamera(), pixel, pairAt(seed, params.sampleBegin, 0u), seed, params.sampleBegin);
  Tally tally = Tally(0u, 0u, 0u, 0u, 0.0);
  uint vertices = 0u;
  bool ended = false;
  while (!ended) {
    uint at = first + RECORD_HEADER + vertices * RECORD_VERTEX_ROWS;
    vertices += 1u;
    recordState(at + RECORD_STATE, path);
    Hit hit = nextHit(path, seed, l);
    bool left = hit.primitive == NO_PRIMITIVE;
    recordRows[at + RECORD_HIT] = vec4(hit.t, indexNumber(hit.primitive), uintBitsToFloat(hit.triangle), 0.0);
    uint primitive = min(hit.primitive, l.end - 1u);
    Vertex v = vertexAt(Hit(hit.t, primitive, hit.triangle), path, seed, l);
    path = arrived(path, hit.t);
    recordSurface(at + RECORD_SURFACE, v);
    bool alive = maxComponent(path.throughput) > 0.0;
    vec3 met = alive ? metLight(path, v, left) : vec3(0.0);
    recordRows[at + RECORD_MET] = vec4(met, 0.0);
    addLight(path, tally, met, path.bounce);
    if (!left && alive && samplesLights(path)) addLight(path, tally, recordLights(at + RECORD_LIGHTS, v, tally, l), path.bounce + 1u);
    ended = endsAt(path, v, left);
    BsdfSample next = nextDirection(v);
    path = continued(path, hit.t, v, next);
    recordRows[at + RECORD_NEXT] = vec4(next.wi, next.pdf);
    recordRows[at + RECORD_NEXT + 1u] = vec4(next.weight, truth(ended));
    recordRows[at + RECORD_NEXT + 2u] = vec4(path.throughput, 0.0);
  }
  recordRows[first] = vec4(float(vertices), 0.0, 0.0, 0.0);
  recordRows[first + 1u] = vec4(path.radiance, 0.0);
}

#endif
