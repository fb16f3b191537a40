// SPDX-License-Identifier: MIT
// The hierarchy over the scene: instances of meshes and, where there are many, bounded analytic shapes alike. A leaf is one
// primitive, whose index tells its kind.
#ifndef TOP_LEVEL_GLSL
#define TOP_LEVEL_GLSL
#include "alpha.glsl"
#include "bvh.glsl"
#include "primitives.glsl"

layout(constant_id = 38) const bool kOneInstance = false;

uint topStack[TOP_LEVEL_DEPTH + 1u];
float topEnter[TOP_LEVEL_DEPTH + 1u];

uint afterTopNode(uint row, BoxRay ray, float tMax, inout uint height) {
  vec4 lowA = fetchRow(row);
  vec4 lowB = fetchRow(row + 2u);
  float enterA = enterBox(ray, lowA.xyz, fetchRow(row + 1u).xyz, kAlpha ? passed.t : 0.0, tMax);
  float enterB = enterBox(ray, lowB.xyz, fetchRow(row + 3u).xyz, kAlpha ? passed.t : 0.0, tMax);
  Order o = inOrder(enterA, enterB, lowA.w, lowB.w);
  uint popped = unlessBeyond(topStack[height - 1u], topEnter[height - 1u], tMax);
  topStack[height] = o.later;
  topEnter[height] = o.laterEnter;
  height += o.both ? 1u : 0u;
  height -= o.none ? 1u : 0u;
  return o.none ? popped : o.next;
}

// Whether the mesh is there only in part: then its nearest surface has to be found before it is decided about.
bool isPartial(uint primitive) {
  uint row = params.materialRow + primitive * MATERIAL_ROWS;
  return kAlpha && (floatBitsToUint(fetchRow(row + 1u).w) & MATERIAL_ALPHA) != 0u;
}

// `any`: a mesh that touches the light must not hide it by the last digits of its place, so the ray ends a little earlier.
void hitInstance(inout Hit hit, Ray ray, uint primitive, bool there, bool any, Layout l) {
  uint row = instanceRow(l, primitive);
  LocalRay local = toUnit(ray.o, ray.d, fetchRow(row), fetchRow(row + 1u), fetchRow(row + 2u));
  vec4 bits = fetchRow(row + 3u);
  float end = any ? hit.t - 1e-6 * (hit.t + maxComponent(abs(ray.o))) : hit.t;
  Hit mesh = Hit(end, hit.primitive, hit.triangle);
  hitMesh(mesh, local, there ? 0u : BVH_END, floatBitsToUint(bits.x), floatBitsToUint(bits.y), primitive,
          any && !isPartial(primitive));
  hit.t = mesh.t < end ? mesh.t : hit.t;
  hit.primitive = mesh.primitive;
  hit.triangle = mesh.triangle;
}

// Of two shapes at one distance the first counts, as in a list: the order of the hierarchy must not show.
void nearerShape(inout Hit hit, float t, uint primitive) {
  bool closer = t < hit.t || (t == hit.t && t < INFINITE && primitive < hit.primitive);
  hit.t = closer ? t : hit.t;
  hit.primitive = closer ? primitive : hit.primitive;
  hit.triangle = closer ? 0u : hit.triangle;
}

// The margin of the boxes covers what rounding does to the tests of shapes seen from far away (renderer/top_level.cpp).
void hitTopLevel(inout Hit hit, Ray ray, uint target, bool any, Layout l) {
  float tMax = hit.t;
  BoxRay box = boxRay(ray.o, ray.d, kShapeHierarchy ? 6e-7 * maxComponent(abs(ray.o)) : 0.0);
  uint topRow = params.topLevelRow;
  bool open = kShapeHierarchy ? tMax > 0.0 : params.instanceCount > 0u;
  uint node = open ? 0u : BVH_END;
  uint height = 1u;
  topStack[0] = BVH_END;
  topEnter[0] = 0.0;
  while (node != BVH_END) {
    while (node < BVH_LEAF) node = afterTopNode(topRow + node, box, hit.t, height);
    bool there = node != BVH_END && node != BVH_NOTHING;
    uint primitive = there ? node & BVH_FIRST_MASK : NO_PRIMITIVE;
    if (kShapeHierarchy) nearerShape(hit, hitShape(ray, primitive, tMax, target, any, l), primitive);
    if (kMeshes) {
      bool mesh = kShapeHierarchy ? there && primitive >= l.instance : there;
      hitInstance(hit, ray, mesh ? primitive : l.instance, mesh, any, l);
    }
    height = max(height, 1u) - 1u;
    bool enough = any && hit.t < tMax;
    if (kAlpha && kMeshes) enough = enough && !(hit.triangle != 0u && isPartial(hit.primitive));
    node = enough ? BVH_END : topStack[height];
  }
  traversalCut = traversalCut || node != BVH_END;
}

void hitBehindPassed(inout Hit hit, Ray ray, uint target, bool any, Layout l) {
  if (kOneInstance) hitInstance(hit, ray, l.instance, true, any, l);
  else hitTopLevel(hit, ray, target, any, l);
}

// Whether the ray goes on through the surface of a mesh that it met.
bool passes(Hit hit, Ray ray, Layout l) {
  uint primitive = clamp(hit.primitive, l.instance, l.end - 1u);
  uint row = instanceRow(l, primitive);
  LocalRay local = toUnit(ray.o, ray.d, fetchRow(row), fetchRow(row + 1u), fetchRow(row + 2u));
  TriangleHit found = hitTriangle(local.o, shearAlong(local.d), fetchMesh(hit.triangle).xyz, fetchMesh(hit.triangle + 1u).xyz,
                                  fetchMesh(hit.triangle + 2u).xyz);
  return hit.triangle != 0u && isPartial(primitive) && !isMet(primitive, hit.triangle, found.weights);
}

// Everything that lies in the hierarchy; `any`: the first hit found is enough. Opacity is looked up for the nearest surface
// only, and the search begins again behind one that the ray passes: drivers that run both sides of every branch would look it
// up for every triangle that is tested (1.4 times the time of projects/still-life on lavapipe).
void hitHierarchy(inout Hit hit, Ray ray, uint target, bool any, Layout l) {
  Hit begin = hit;
  passed = Hit(0.0, 0u, 0u);
  bool again = kAlpha && kMeshes;
  if (!again) hitBehindPassed(hit, ray, target, any, l);
  while (again) {
    hit = begin;
    hitBehindPassed(hit, ray, target, any, l);
    again = passes(hit, ray, l);
    passed = hit;
  }
}

#endif
