// SPDX-License-Identifier: MIT
// Closest hit and occlusion. Few analytic shapes are a flat list, the spheres and planes of small scenes in registers (loaded
// once, counts baked); where there are many, all that have bounds lie in the hierarchy beside the meshes.
#ifndef TRAVERSE_GLSL
#define TRAVERSE_GLSL
#extension GL_EXT_control_flow_attributes : require
#include "top_level.glsl"

vec4 bakedSpheres[MAX_FIXED];
vec4 bakedPlanes[MAX_FIXED];

// Called once at the top of main, outside all control flow.
void loadBakedPrimitives() {
  [[unroll]] for (uint i = 0u; i < kFixedSpheres; ++i) bakedSpheres[i] = fetchRow(kFirstRow + i);
  [[unroll]] for (uint i = 0u; i < kFixedPlanes; ++i) bakedPlanes[i] = fetchRow(kFirstRow + sphereCount() + i);
}

void nearer(inout Hit hit, float t, uint primitive) {
  bool closer = t < hit.t;
  hit.t = closer ? t : hit.t;
  hit.primitive = closer ? primitive : hit.primitive;
}

void hitSpheresAndPlanes(inout Hit hit, Ray ray, Layout l) {
  if (kSpheres && !kShapeHierarchy) {
    if (kFixedSpheres > 0u) {
      [[unroll]] for (uint i = 0u; i < kFixedSpheres; ++i)
        nearer(hit, hitSphere(ray.o, ray.d, bakedSpheres[i].xyz, bakedSpheres[i].w, ray.self == i, ray.selfInside), i);
    } else {
      for (uint i = 0u; i < l.plane; ++i) {
        vec4 s = fetchRow(kFirstRow + i);
        nearer(hit, hitSphere(ray.o, ray.d, s.xyz, s.w, ray.self == i, ray.selfInside), i);
      }
    }
  }
  if (kPlanes) {
    if (kFixedPlanes > 0u) {
      [[unroll]] for (uint i = 0u; i < kFixedPlanes; ++i)
        nearer(hit, hitPlane(ray.o, ray.d, bakedPlanes[i], ray.self == l.plane + i), l.plane + i);
    } else {
      for (uint i = l.plane; i < l.largeSphere; ++i)
        nearer(hit, hitPlane(ray.o, ray.d, fetchRow(kFirstRow + i), ray.self == i), i);
    }
  }
}

void hitLargeSpheres(inout Hit hit, Ray ray, uint target, Layout l) {
  for (uint i = l.largeSphere; i < l.box; ++i) {
    uint row = largeSphereRow(l, i);
    vec4 high = fetchRow(row);
    vec4 low = fetchRow(row + 1u);
    float t = hitLargeSphere(ray.o, ray.d, high, low, ray.self == i, ray.selfInside);
    nearer(hit, isTarget(i, target) ? INFINITE : t, i);
  }
}

void hitAffineShapes(inout Hit hit, Ray ray, uint target, Layout l) {
  if (kBoxes)
    for (uint i = l.box; i < l.rect; ++i)
      nearer(hit, isSolidTarget(i, target) ? INFINITE : hitBox(localRay(ray, l, i), ray.self == i, ray.selfInside), i);
  if (kRects)
    for (uint i = l.rect; i < l.disk; ++i) 
      nearer(hit, hitRect(localRay(ray, l, i), ray.self == i || isTarget(i, target)), i);
  if (kDisks)
    for (uint i = l.disk; i < l.cylinder; ++i) 
      nearer(hit, hitDisk(localRay(ray, l, i), ray.self == i || isTarget(i, target)), i);
  if (kCylinders)
    for (uint i = l.cylinder; i < l.ellipsoid; ++i)
      nearer(hit, isSolidTarget(i, target) ? INFINITE : hitCylinder(localRay(ray, l, i), ray.self == i, ray.selfInside), i);
  if (kEllipsoids)
    for (uint i = l.ellipsoid; i < l.instance; ++i)
      nearer(hit, isSolidTarget(i, target) ? INFINITE : hitEllipsoid(localRay(ray, l, i), ray.self == i, ray.selfInside), i);
}

void hitOtherShapes(inout Hit hit, Ray ray, uint target, Layout l) {
  if (kLargeSpheres) hitLargeSpheres(hit, ray, target, l);
  if (kAffine && !kShapeHierarchy) hitAffineShapes(hit, ray, target, l);
}

// Nearest hit closer than tMax; primitive = NO_PRIMITIVE when there is none.
Hit closestHit(Ray ray, float tMax, Layout l) {
  Hit hit = Hit(tMax, NO_PRIMITIVE, 0u);
  hitSpheresAndPlanes(hit, ray, l);
  hitOtherShapes(hit, ray, NO_PRIMITIVE, l);
  if (kMeshes || kShapeHierarchy) hitHierarchy(hit, ray, NO_PRIMITIVE, false, l);
  return hit;
}

bool spheresBlock(Ray ray, float tMax, uint target, Layout l) {
  bool blocked = false;
  if (kFixedSpheres > 0u) {
    [[unroll]] for (uint i = 0u; i < kFixedSpheres; ++i) {
      vec4 s = bakedSpheres[i];
      bool hit = blocksSphere(ray.o, ray.d, tMax, s.xyz, s.w, ray.self == i, ray.selfInside);
      blocked = blocked || (hit && !isTarget(i, target));
    }
  } else {
    for (uint i = 0u; i < l.plane; ++i) {
      vec4 s = fetchRow(kFirstRow + i);
      bool hit = blocksSphere(ray.o, ray.d, tMax, s.xyz, s.w, ray.self == i, ray.selfInside);
      blocked = blocked || (hit && !isTarget(i, target));
    }
  }
  return blocked;
}

bool planesBlock(Ray ray, float tMax, Layout l) {
  bool blocked = false;
  if (kFixedPlanes > 0u) {
    [[unroll]] for (uint i = 0u; i < kFixedPlanes; ++i) {
      bool hit = blocksPlane(ray.o, ray.d, tMax, bakedPlanes[i], ray.self == l.plane + i);
      blocked = blocked || hit;
    }
  } else {
    for (uint i = l.plane; i < l.largeSphere; ++i) {
      bool hit = blocksPlane(ray.o, ray.d, tMax, fetchRow(kFirstRow + i), ray.self == i);
      blocked = blocked || hit;
    }
  }
  return blocked;
}

// Whether anything but the target lies between the ray's origin and tMax.
bool occluded(Ray ray, float tMax, uint target, Layout l) {
  bool bySphere = kSpheres && !kShapeHierarchy ? spheresBlock(ray, tMax, target, l) : false;
  bool byPlane = kPlanes ? planesBlock(ray, tMax, l) : false;
  Hit hit = Hit(tMax, NO_PRIMITIVE, 0u);
  hitOtherShapes(hit, ray, target, l);
  bool blocked = bySphere || byPlane || hit.t < tMax;
  if (kMeshes || kShapeHierarchy) {
    Hit first = Hit(blocked ? 0.0 : tMax, NO_PRIMITIVE, 0u);
    hitHierarchy(first, ray, target, true, l);
    blocked = blocked || first.primitive != NO_PRIMITIVE;
  }
  return blocked;
}

#endif
