// SPDX-License-Identifier: MIT
// The sky around everything: radiance from a direction, and directions in proportion to it. The image is looked up without
// interpolation, so that the piecewise constant density is that of the lookup.
#ifndef ENVIRONMENT_GLSL
#define ENVIRONMENT_GLSL
#include "lights.glsl"
#include "sphere_map.glsl"

bool hasEnvironment() { return kEnvironment && (params.flags & TRACE_ENVIRONMENT) != 0u; }

// Tables of the image, behind ENERGY_ROWS (renderer/gpu_environment.cpp): 1 / integral of the luminance, brightest channel, -, - |
// for each row: distance of its upper or lower edge from the nearer pole, its height, -, share of it and all above |
// for each texel: radiance, share of it and all to its left in the row
const uint kSkyRows = ENERGY_ROWS + 1u;

struct Sky {
  vec3 zenith, horizon, ground;
  float columns, rows;  // of the image, at least 1
  bool sampled;         // as a light; else only paths meet it
  bool image;
  vec3 right, up, back;  // its axes in the world
};

Sky fetchSky() {
  vec4 zenith = fetchRow(params.environmentRow);
  vec4 horizon = fetchRow(params.environmentRow + 1u);
  vec4 ground = fetchRow(params.environmentRow + 2u);
  Sky sky;
  sky.zenith = zenith.xyz;
  sky.horizon = horizon.xyz;
  sky.ground = ground.xyz;
  sky.columns = max(zenith.w, 1.0);
  sky.rows = max(horizon.w, 1.0);
  sky.sampled = kSampledSky && ground.w > 0.0;
  sky.image = kSampledSky && zenith.w > 0.0;
  sky.right = fetchRow(params.environmentRow + 3u).xyz;
  sky.up = fetchRow(params.environmentRow + 4u).xyz;
  sky.back = fetchRow(params.environmentRow + 5u).xyz;
  return sky;
}

vec3 skyGradient(Sky sky, float y) { return mix(sky.horizon, y > 0.0 ? sky.zenith : sky.ground, min(abs(y), 1.0)); }

// Integral of the gradient's luminance over the half sphere towards `pole`: the mean of a linear function of the height.
float hemisphereLuminance(Sky sky, vec3 pole) { return PI * (luminance(sky.horizon) + luminance(pole)); }

// What the sky shows in one direction, and the density with which sampleEnvironment() chooses that direction.
struct SkyValue {
  vec3 radiance;  // nit
  float pdf;      // per solid angle; 0 = never
};

// e: unit, the sky's own axes; the texel is ignored without an image.
SkyValue skyValue(Sky sky, vec3 e, MapCell cell) {
  vec3 gradient = skyGradient(sky, e.y);
  float total = hemisphereLuminance(sky, sky.zenith) + hemisphereLuminance(sky, sky.ground);
  SkyValue value = SkyValue(gradient, sky.sampled ? luminance(gradient) / max(total, 1e-30) : 0.0);
  if (kSampledSky) {
    uint at = sky.image ? kSkyRows + uint(sky.rows) + cell.row * uint(sky.columns) + cell.column : 0u;
    vec3 texel = fetchTable(at).xyz;
    float density = luminance(texel) * fetchTable(sky.image ? ENERGY_ROWS : 0u).x;
    value.radiance = sky.image ? gradient * texel : value.radiance;
    value.pdf = sky.image ? density : value.pdf;
  }
  return value;
}

SkyValue environmentAt(vec3 d) {
  Sky sky = fetchSky();
  vec3 e = vec3(dot(sky.right, d), dot(sky.up, d), dot(sky.back, d));
  MapCell cell = MapCell(0u, 0u);
  if (kSampledSky) cell = mapCell(e, sky.columns, sky.rows);
  return skyValue(sky, e, cell);
}

// nit, from unit direction d (world axes).
vec3 environmentRadiance(vec3 d) { return environmentAt(d).radiance; }

// Density with which sampleEnvironment() chooses unit direction d.
float environmentPdf(vec3 d) { return environmentAt(d).pdf; }

// One of a run of table rows, and where in its share u fell, [0, 1].
struct SkyChoice {
  uint index;
  float rest;
};

// The first row whose share in w, counted from the start of the run, exceeds u.
SkyChoice chooseShare(uint first, uint count, float u) {
  uint low = 0u;
  uint high = count - 1u;
  while (low < high) {
    uint middle = (low + high) / 2u;
    bool here = u < fetchTable(first + middle).w;
    high = here ? middle : high;
    low = here ? low : middle + 1u;
  }
  float begin = low > 0u ? fetchTable(first + low - 1u).w : 0.0;
  float share = fetchTable(first + low).w - begin;
  return SkyChoice(low, clamp((u - begin) / max(share, 1e-30), 0.0, 1.0));
}

// u chooses the height, v the azimuth; (u, v) in [0, 1)^2. Density 0, and no light, from a sky that is black or not sampled.
LightSample sampleEnvironment(float u, float v) {
  Sky sky = fetchSky();
  float below = hemisphereLuminance(sky, sky.ground);
  float above = hemisphereLuminance(sky, sky.zenith);
  float share = above / max(above + below, 1e-30);
  bool upper = u < share;
  float rest = upper ? u / share : (u - share) / (1.0 - share);
  precise float fromPole = 1.0 - sampleLinear(rest, luminance(sky.horizon), luminance(upper ? sky.zenith : sky.ground));
  float across = v;
  MapCell cell = MapCell(0u, 0u);
  if (kSampledSky) {
    uint rows = sky.image ? uint(sky.rows) : 1u;
    uint columns = sky.image ? uint(sky.columns) : 1u;
    uint first = sky.image ? kSkyRows : 0u;
    SkyChoice row = chooseShare(first, rows, u);
    SkyChoice column = chooseShare(first + rows + row.index * columns, columns, v);
    vec4 band = fetchTable(first + row.index);
    bool upperRow = 2u * row.index < rows;
    fromPole = sky.image ? band.x + band.y * (upperRow ? row.rest : 1.0 - row.rest) : fromPole;
    upper = sky.image ? upperRow : upper;
    across = sky.image ? (float(column.index) + column.rest) / sky.columns : across;
    cell = MapCell(column.index, row.index);
  }
  vec3 e = mapDirection(across, fromPole, upper);
  SkyValue value = skyValue(sky, e, cell);
  vec3 wi = sky.right * e.x + sky.up * e.y + sky.back * e.z;
  vec3 arriving = value.pdf > 0.0 ? value.radiance / value.pdf : vec3(0.0);
  return LightSample(wi, INFINITE, arriving, value.pdf, NO_PRIMITIVE, vec3(0.0));
}

#endif
