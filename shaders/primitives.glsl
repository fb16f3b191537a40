// SPDX-License-Identifier: MIT
// Rays, and one bounded analytic shape by its index: what a leaf of the hierarchy over a scene holds.
#ifndef PRIMITIVES_GLSL
#define PRIMITIVES_GLSL
#include "scene.glsl"
#include "shapes.glsl"

struct Ray {
  vec3 o;
  vec3 d;           // unit length
  uint self;        // primitive the ray starts on, or NO_PRIMITIVE
  bool selfInside;  // and whether it leaves to that solid's inside
};

// Occlusion leaves out one primitive: the light that the ray is sent to (NO_PRIMITIVE = none).
bool isTarget(uint primitive, uint target) { return kAreaLights && primitive == target; }

// The same of boxes, cylinders and ellipsoids.
bool isSolidTarget(uint primitive, uint target) { return kSolidLights && primitive == target; }

LocalRay localRay(Ray ray, Layout l, uint primitive) {
  uint row = affineRow(l, primitive);
  return toUnit(ray.o, ray.d, fetchRow(row), fetchRow(row + 1u), fetchRow(row + 2u));
}

// A shadow ray (`any`) only asks whether the sphere lies before tMax, which is answered by 0.
float hitSphereAt(Ray ray, uint primitive, float tMax, uint target, bool any, Layout l) {
  vec4 s = fetchRow(kFirstRow + primitive);
  bool self = ray.self == primitive;
  float t = INFINITE;
  if (any) t = blocksSphere(ray.o, ray.d, tMax, s.xyz, s.w, self, ray.selfInside) && !isTarget(primitive, target) ? 0.0 : INFINITE;
  else t = hitSphere(ray.o, ray.d, s.xyz, s.w, self, ray.selfInside);
  return t;
}

// The primitive is of one of the kinds from boxes to ellipsoids.
float hitAffineAt(Ray ray, uint primitive, uint target, Layout l) {
  LocalRay local = localRay(ray, l, primitive);
  bool self = ray.self == primitive;
  bool leftOut = self || isTarget(primitive, target);
  float t = INFINITE;
  if (kBoxes && primitive < l.rect) t = hitBox(local, self, ray.selfInside);
  if (kRects && primitive >= l.rect && primitive < l.disk) t = hitRect(local, leftOut);
  if (kDisks && primitive >= l.disk && primitive < l.cylinder) t = hitDisk(local, leftOut);
  if (kCylinders && primitive >= l.cylinder && primitive < l.ellipsoid) t = hitCylinder(local, self, ray.selfInside);
  if (kEllipsoids && primitive >= l.ellipsoid) t = hitEllipsoid(local, self, ray.selfInside);
  if (isSolidTarget(primitive, target)) t = INFINITE;
  return t;
}

// Distance to a shape that has bounds; INFINITE for any other primitive, and for none.
float hitShape(Ray ray, uint primitive, float tMax, uint target, bool any, Layout l) {
  float t = INFINITE;
  if (kSpheres && primitive < l.plane) t = hitSphereAt(ray, primitive, tMax, target, any, l);
  if (kAffine && primitive >= l.box && primitive < l.instance) t = hitAffineAt(ray, primitive, target, l);
  return t;
}

#endif
