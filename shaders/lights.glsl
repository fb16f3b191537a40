// SPDX-License-Identifier: MIT
// What one light sends to a point if nothing is in between. Punctual ones (KHR_lights_punctual) are met by no path;
// lights with a body and suns are, and state the density of both ways.
#ifndef LIGHTS_GLSL
#define LIGHTS_GLSL
#extension GL_EXT_control_flow_attributes : require
#include "scene.glsl"
#include "solid_sampling.glsl"

struct LightSample {
  vec3 wi;           // unit, towards the light
  float distance;    // to the light; INFINITE for a sun
  vec3 illuminance;  // lx at perpendicular incidence; for a light of non-zero size radiance / pdf
  float pdf;         // of wi, per solid angle; 0 for a punctual light
  uint primitive;    // that is the light, which must not shadow itself, or NO_PRIMITIVE
  vec3 place;        // of a light that is a point
};

struct LightRows {
  vec4 a, b, c, d;
};

LightRows fetchLight(uint light) {
  uint row = params.lightRow + light * LIGHT_ROWS;
  LightRows rows;
  rows.a = fetchRow(row);
  rows.b = fetchRow(row + 1u);
  rows.c = kSpotLights || kAreaLights ? fetchRow(row + 2u) : vec4(0.0);
  rows.d = kAreaLights ? fetchRow(row + 3u) : vec4(0.0);
  return rows;
}

LightRows bakedLights[MAX_FIXED_LIGHTS];

// Called once at the top of main, outside all control flow.
void loadBakedLights() {
  [[unroll]] for (uint i = 0u; i < kFixedLights; ++i) bakedLights[i] = fetchLight(i);
}

// The bodies of lights are primitives, so a light's kind implies that of the primitive.
const bool kRoundLights = kSpheres || kLargeSpheres;

// Whether p is on a side of a flat light that shines.
bool facesLight(LightRows light, vec3 p) {
  return light.b.w != 0.0 || dot(p - light.a.xyz, cross(light.c.xyz, light.d.xyz)) > 0.0;
}

LightSample samplePunctual(LightRows light, vec3 p, uint kind) {
  vec3 toLight = light.a.xyz - p;
  float d2 = dot(toLight, toLight);
  float inv = inversesqrt(d2);
  LightSample s = LightSample(toLight * inv, d2 * inv, light.b.xyz * (inv * inv), 0.0, NO_PRIMITIVE, light.a.xyz);
  if (kSpotLights) {
    // Smooth edge between the cones as the extension defines it.
    float edge = clamp(-dot(light.c.xyz, s.wi) * light.b.w + light.c.w, 0.0, 1.0);
    s.illuminance *= kind == LIGHT_SPOT ? edge * edge : 1.0;
  }
  return s;
}

// A parallel light; with a disc its directions fill a cone, and E = radiance * pi * sin^2 of its half angle.
LightSample sampleDirectional(LightRows light, float u, float v) {
  LightSample s = LightSample(light.a.xyz, INFINITE, light.b.xyz, 0.0, NO_PRIMITIVE, vec3(0.0));
  if (kSuns && light.b.w > 0.0) {
    s.wi = coneDirection(light.a.xyz, u * light.b.w, v);
    s.illuminance = light.b.xyz * (2.0 / (2.0 - light.b.w));
    s.pdf = conePdf(light.b.w);
  }
  return s;
}

LightSample sampleArea(LightRows light, vec3 p, uint kind, float u, float v) {
  LightDirection d = LightDirection(vec3(0.0, 0.0, 1.0), 0.0, 0.0);
  if (kRoundLights && kind == LIGHT_SPHERE) d = sampleSphere(p, light.a.xyz, light.b.w, u, v);
  if (kRects && kind == LIGHT_RECT) d = sampleRect(p, light.a.xyz, light.c.xyz, light.d.xyz, u, v);
  if (kDisks && kind == LIGHT_DISK) d = sampleDisk(p, light.a.xyz, light.c.xyz, light.d.xyz, u, v);
  bool dark = (kRects || kDisks) && kind != LIGHT_SPHERE && !facesLight(light, p);
  float pdf = dark ? 0.0 : d.pdf;
  vec3 illuminance = pdf > 0.0 ? light.b.xyz / pdf : vec3(0.0);
  return LightSample(d.wi, d.distance, illuminance, pdf, floatBitsToUint(light.d.w), vec3(0.0));
}

SolidKinds solidKinds() { return SolidKinds(kBoxLights, kCylinderLights, kEllipsoidLights); }
bool isSolidLight(uint kind) { return kSolidLights && kind >= LIGHT_BOX; }

SolidSpace solidLightSpace(LightRows light, uint kind, vec3 p) {
  uint row = floatBitsToUint(light.d.x);
  return solidSpace(kind, p, fetchRow(row), fetchRow(row + 1u), fetchRow(row + 2u));
}

LightSample sampleSolidLight(LightRows light, vec3 p, uint kind, float u, float v) {
  LightDirection d = sampleSolid(kind, solidLightSpace(light, kind, p), u, v, solidKinds());
  vec3 illuminance = d.pdf > 0.0 ? light.b.xyz / d.pdf : vec3(0.0);
  return LightSample(d.wi, d.distance, illuminance, d.pdf, floatBitsToUint(light.d.w), vec3(0.0));
}

// (u, v) in [0, 1)^2, used by lights of non-zero size only.
LightSample sampleLight(LightRows light, vec3 p, float u, float v) {
  uint kind = uint(light.a.w);
  LightSample s = samplePunctual(light, p, kind);
  if (kDirectionalLights && kind == LIGHT_DIRECTIONAL) s = sampleDirectional(light, u, v);
  if (kAreaLights && kind >= LIGHT_SPHERE) s = sampleArea(light, p, kind, u, v);
  if (isSolidLight(kind)) s = sampleSolidLight(light, p, kind, u, v);
  return s;
}

// The same as lightPdf() of a sun, 0 for parallel light.
float sunPdf(LightRows light) { return light.b.w > 0.0 ? conePdf(light.b.w) : 0.0; }

// Density with which sampleLight() would have chosen wi, given that a ray from p along wi meets this light; 0 for a
// punctual one.
float lightPdf(LightRows light, vec3 p, vec3 wi) {
  uint kind = uint(light.a.w);
  float pdf = 0.0;
  if (kSuns && kind == LIGHT_DIRECTIONAL) pdf = sunPdf(light);
  if (kAreaLights) {
    if (kRoundLights && kind == LIGHT_SPHERE) pdf = spherePdf(p, light.a.xyz, light.b.w, wi);
    if (kRects && kind == LIGHT_RECT) pdf = rectPdf(p, light.a.xyz, light.c.xyz, light.d.xyz, wi);
    if (kDisks && kind == LIGHT_DISK) pdf = diskPdf(p, light.a.xyz, light.c.xyz, light.d.xyz, wi);
    if ((kRects || kDisks) && kind > LIGHT_SPHERE) pdf = facesLight(light, p) ? pdf : 0.0;
    if (isSolidLight(kind)) pdf = solidPdf(kind, solidLightSpace(light, kind, p), wi, solidKinds());
  }
  return pdf;
}

// Radiance of a sun's disc along wi, 0 beside it.
vec3 sunRadiance(LightRows light, vec3 wi) {
  float x = light.b.w;
  return inCone(wi, light.a.xyz, x) ? light.b.xyz / (PI * x * (2.0 - x)) : vec3(0.0);
}

#endif
