// SPDX-License-Identifier: MIT
// One production function per operation, on five rows of numbers; compiled for the device and, by
// cmake/GlslAsCpp.cmake, for C++ in float and in double.
#ifndef ROUNDING_GLSL
#define ROUNDING_GLSL
#include "bsdf_sampling.glsl"
#include "solid_sampling.glsl"
#include "numerics.glsl"
#include "sampling.glsl"
#include "random.glsl"
#include "shapes.glsl"
#include "sphere_map.glsl"
#include "triangle.glsl"
#include "triangle_sampling.glsl"

vec4 scalar(float x) { return vec4(x, 0.0, 0.0, 0.0); }

// (o, -) (d, -) and up to three rows of the shape.
vec4 roundShape(uint operation, vec4 a, vec4 b, vec4 c, vec4 d, vec4 e) {
  LocalRay ray = toUnit(a.xyz, b.xyz, c, d, e);
  float t = INFINITE;
  if (operation == 0u) t = hitSphere(a.xyz, b.xyz, c.xyz, c.w, false, false);
  if (operation == 1u) t = hitLargeSphere(a.xyz, b.xyz, c, d, false, false);
  if (operation == 2u) t = hitPlane(planeTerms(a.xyz, b.xyz, c), false);
  if (operation == 3u) t = hitBox(ray, false, false);
  if (operation == 4u) t = hitCylinder(ray, false, false);
  if (operation == 5u) t = hitEllipsoid(ray, false, false);
  if (operation == 6u) t = hitRect(ray, false);
  if (operation == 7u) t = hitDisk(ray, false);
  return scalar(t);
}

// (o, -) (d, -) and the corners: distance, or weights that sum to 1.
vec4 roundTriangle(uint operation, vec4 a, vec4 b, vec4 c, vec4 d, vec4 e) {
  TriangleHit hit = hitTriangle(a.xyz, shearAlong(b.xyz), c.xyz, d.xyz, e.xyz);
  vec3 w = hit.weights;
  vec4 weights = vec4(w * (1.0 / (w.x + w.y + w.z)), 0.0);
  return hit.t >= INFINITE || operation == 30u ? scalar(hit.t) : weights;
}

// (wo, alpha) (wi below, eta) (facet, -): a total reflection is a miss.
vec4 roundRefraction(uint operation, vec4 a, vec4 b, vec4 c) {
  vec3 wo = a.xyz;
  vec3 wi = b.xyz;
  vec3 h = wo + wi * b.w;
  vec3 bent = refracted(wo, c.xyz, b.w);
  FacetValue passed = refractingFacets(h, dot(h, h), wo, wi, b.w, a.w);
  vec4 result = bent.z == 1.0 ? scalar(INFINITE) : vec4(bent, 0.0);
  if (operation == 33u) result = scalar(passed.fCos);
  if (operation == 34u) result = scalar(passed.pdf);
  return result;
}

// (u, v, alpha, bits) (direction, -) (a, b, cone, -).
vec4 roundWarp(uint operation, vec4 a, vec4 b, vec4 c) {
  CosSin azimuth = cosSinTurn(a.y);
  uint index = floatBitsToUint(a.w);
  SamplePair pair = samplePair(hashUint(index), index, index >> 20);
  vec4 result = vec4(0.0);
  if (operation == 40u) result = vec4(unit(anyNormal(a.z, azimuth.c, azimuth.s, a.x)), 0.0);
  if (operation == 41u) result = vec4(coneDirection(b.xyz, a.x * c.z, a.y), 0.0);
  if (operation == 42u) result = scalar(sampleLinear(a.x, c.x, c.y));
  if (operation == 43u) result = vec4(mapDirection(a.y, a.x, b.y > 0.0), 0.0);
  if (operation == 44u) result = scalar(turnOf(b.y, b.x));
  if (operation == 45u) result = vec4(pair.x, pair.y, sampleIndependent(index, index >> 7, 3u), 0.0);
  return result;
}

// (wo, alpha) (wi, eta) (u, v, -, -).
vec4 roundScattering(uint operation, vec4 a, vec4 b, vec4 c) {
  vec3 wo = a.xyz;
  vec3 wi = b.xyz;
  vec3 h = wo + wi;
  CosSin azimuth = cosSinTurn(c.y);
  vec4 result = vec4(0.0);
  if (operation == 10u) result = scalar(ggxD(h, dot(h, h), a.w));
  if (operation == 11u) result = scalar(smithG2(wo.z, wi.z, a.w));
  if (operation == 12u) result = scalar(fresnelDielectric(wo.z, b.w));
  if (operation == 13u) result = scalar(reflectingFacets(h, dot(h, h), wo.z, wi.z, a.w).fCos);
  if (operation == 14u) result = scalar(reflectingFacets(h, dot(h, h), wo.z, wi.z, a.w).pdf);
  if (operation == 15u) result = vec4(normalize(visibleNormal(wo, a.w, ggxA(wo.z, a.w), azimuth.c, azimuth.s, c.x)), 0.0);
  if (operation == 16u) result = vec4(cosineHemisphere(azimuth.c, azimuth.s, c.x), 0.0);
  if (operation == 17u) result = vec4(azimuth.c, azimuth.s, 0.0, 0.0);
  if (operation == 18u) result = vec4(frameAround(wo).t, 0.0);
  if (operation == 19u) result = scalar(powerHeuristic(a.w, b.w));
  return result;
}

// (p, u) (centre, v) (half edge or axis, radius) (half edge or axis, -).
vec4 roundLight(uint operation, vec4 a, vec4 b, vec4 c, vec4 d) {
  LightDirection s = LightDirection(vec3(0.0), 0.0, 0.0);
  if (operation == 20u || operation == 21u) s = sampleSphere(a.xyz, b.xyz, c.w, a.w, b.w);
  if (operation == 22u || operation == 23u) s = sampleRect(a.xyz, b.xyz, c.xyz, d.xyz, a.w, b.w);
  if (operation == 24u || operation == 25u) s = sampleDisk(a.xyz, b.xyz, c.xyz, d.xyz, a.w, b.w);
  return (operation & 1u) == 0u ? vec4(s.wi, 0.0) : scalar(s.pdf);
}

// (corner, u) (edge, v) (edge, -) of a triangle around the origin.
vec4 roundGlowingTriangle(uint operation, vec4 a, vec4 b, vec4 c) {
  TriangleSample s = sampleTriangle(triangleView(a.xyz, b.xyz, c.xyz), a.w, b.w);
  return operation == 26u ? vec4(normalize(s.toPoint), 0.0) : scalar(s.pdf);
}

// (p, u) (-, v) (rows of unitFromWorld with the centre): directions and densities of a box, a cylinder, an ellipsoid.
vec4 roundSolid(uint operation, vec4 a, vec4 b, vec4 c, vec4 d, vec4 e) {
  uint kind = LIGHT_BOX + (operation - 50u) / 2u;
  LightDirection s = sampleSolid(kind, solidSpace(kind, a.xyz, c, d, e), a.w, b.w, SolidKinds(true, true, true));
  return (operation & 1u) == 0u ? vec4(s.wi, 0.0) : scalar(s.pdf);
}

vec4 rounded(uint operation, vec4 a, vec4 b, vec4 c, vec4 d, vec4 e) {
  vec4 result = vec4(0.0);
  if (operation < 10u) result = roundShape(operation, a, b, c, d, e);
  else if (operation < 20u) result = roundScattering(operation, a, b, c);
  else if (operation < 26u) result = roundLight(operation, a, b, c, d);
  else if (operation < 30u) result = roundGlowingTriangle(operation, a, b, c);
  else if (operation < 32u) result = roundTriangle(operation, a, b, c, d, e);
  else if (operation < 40u) result = roundRefraction(operation, a, b, c);
  else if (operation < 50u) result = roundWarp(operation, a, b, c);
  else result = roundSolid(operation, a, b, c, d, e);
  return result;
}

#endif
