// SPDX-License-Identifier: MIT
// Punctual lights (KHR_lights_punctual): what arrives at a point if nothing is in between.
#ifndef LIGHTS_GLSL
#define LIGHTS_GLSL
#extension GL_EXT_control_flow_attributes : require
#include "scene.glsl"

struct LightSample {
  vec3 wi;           // unit, towards the light
  float distance;    // to the light; INFINITE for a directional one
  vec3 illuminance;  // lx at perpendicular incidence
};

struct LightRows {
  vec4 a, b, c;
};

LightRows fetchLight(uint light) {
  uint row = params.lightRow + light * LIGHT_ROWS;
  LightRows rows;
  rows.a = fetchRow(row);
  rows.b = fetchRow(row + 1u);
  rows.c = kSpotLights ? fetchRow(row + 2u) : vec4(0.0);
  return rows;
}

LightRows bakedLights[MAX_FIXED_LIGHTS];

// Called once at the top of main, outside all control flow.
void loadBakedLights() {
  [[unroll]] for (uint i = 0u; i < kFixedLights; ++i) bakedLights[i] = fetchLight(i);
}

LightSample sampleLight(LightRows light, vec3 p) {
  uint kind = uint(light.a.w);
  bool directional = kDirectionalLights && kind == LIGHT_DIRECTIONAL;
  vec3 toLight = light.a.xyz - p;
  float d2 = dot(toLight, toLight);
  float inv = inversesqrt(d2);
  LightSample s = LightSample(toLight * inv, d2 * inv, light.b.xyz * (inv * inv));
  if (kSpotLights) {
    // Smooth edge between the cones as the extension defines it.
    float edge = clamp(-dot(light.c.xyz, s.wi) * light.b.w + light.c.w, 0.0, 1.0);
    s.illuminance *= kind == LIGHT_SPOT ? edge * edge : 1.0;
  }
  if (directional) s = LightSample(light.a.xyz, INFINITE, light.b.xyz);
  return s;
}

#endif
