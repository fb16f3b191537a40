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

// v's component along the axis that a plane faces.
float alongAxis(uint facing, vec3 v) {
  uint axis = (facing - 1u) % 3u;
  return axis == 0u ? v.x : (axis == 1u ? v.y : v.z);
}

// Planes that face an axis need no dot products, and two that face each other share the reciprocal: the same bits at half the
// work.
float bakedPlaneHeight(uint i, vec3 p) {
  uint facing = (kPlaneAxes >> (3u * i)) & 7u;
  float d = facing > 3u ? -bakedPlanes[i].w : bakedPlanes[i].w;
  return facing == 0u ? planeHeight(p, bakedPlanes[i]) : d - alongAxis(facing, p);
}

PlaneTerms bakedPlaneTerms(uint i, Ray ray) {
  uint facing = (kPlaneAxes >> (3u * i)) & 7u;
  return facing == 0u ? planeTerms(ray.o, ray.d, bakedPlanes[i]) : PlaneTerms(bakedPlaneHeight(i, ray.o), alongAxis(facing, ray.d));
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
        nearer(hit, hitPlane(bakedPlaneTerms(i, ray), ray.self == l.plane + i), l.plane + i);
    } else {
      for (uint i = l.plane; i < l.largeSphere; ++i)
        nearer(hit, hitPlane(planeTerms(ray.o, ray.d, fetchRow(kFirstRow + i)), ray.self == i), i);
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

// Where a shadow ray ends. A light that is a point has a place: a plane is between if that lies on its other side, which needs
// no direction, and of baked lights and planes is known before the first ray.
struct ShadowEnd {
  float t;
  vec3 place;
  bool placed;
};

ShadowEnd unplaced(float t) { return ShadowEnd(t, vec3(0.0), false); }

bool planeBlocks(PlaneTerms q, float endHeight, ShadowEnd end, bool self) {
  return end.placed ? q.height * endHeight < 0.0 && !self : blocksPlane(q, end.t, self);
}

bool planesBlock(Ray ray, ShadowEnd end, Layout l) {
  bool blocked = false;
  if (kFixedPlanes > 0u) {
    [[unroll]] for (uint i = 0u; i < kFixedPlanes; ++i) {
      bool hit = planeBlocks(bakedPlaneTerms(i, ray), bakedPlaneHeight(i, end.place), end, ray.self == l.plane + i);
      blocked = blocked || hit;
    }
  } else {
    for (uint i = l.plane; i < l.largeSphere; ++i) {
      vec4 plane = fetchRow(kFirstRow + i);
      bool hit = planeBlocks(planeTerms(ray.o, ray.d, plane), planeHeight(end.place, plane), end, ray.self == i);
      blocked = blocked || hit;
    }
  }
  return blocked;
}

// Whether anything but the target lies between the ray's origin and its end.
bool occluded(Ray ray, ShadowEnd end, uint target, Layout l) {
  float tMax = end.t;
  bool bySphere = kSpheres && !kShapeHierarchy ? spheresBlock(ray, tMax, target, l) : false;
  bool byPlane = kPlanes ? planesBlock(ray, end, l) : false;
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
