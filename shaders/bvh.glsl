// SPDX-License-Identifier: MIT
// One mesh: down the hierarchy over its triangles, nearer boxes first.
// Two children a node: four in rows of the same form took 1.5 times as long on lavapipe and 1.0 to 1.08 times on an H100.
// There, all triangles of a leaf in one turn: shadow rays 1.02 times as fast, diffuse ones 0.95 (bench --mesh, 900 to 1M).
// Queues that sort rays by direction are not worth their memory: 262,144 diffuse rays sorted as one are 1.2 times as fast on
// lavapipe, in blocks of 65,536 or fewer 1.05. What lanes lose by waiting for the longest of their 8 rays is more: 2.2 times
// as fast with 8 equal rays, of which caches give 1.3 (300k triangles). Without the distances on the stack 0.68.
#ifndef BVH_GLSL
#define BVH_GLSL
#include "scene.glsl"
#include "shapes.glsl"
#include "triangle.glsl"

// Form of the loop over a mesh: first down to a leaf in a loop of its own, then its triangles in another; or one loop whose
// turns test a node or a triangle. The first suits drivers that run both sides of every branch.
layout(constant_id = 36) const bool kWhileWhile = true;

struct Hit {
  float t;
  uint primitive;
  uint triangle;  // of a mesh: its first row
};

// The last surface of a mesh that the ray passed because it is there only in part: what lies before it does not count, nor
// does what comes first of those at one distance.
Hit passed = Hit(0.0, 0u, 0u);

bool comesBefore(Hit a, Hit b) {
  bool first = a.primitive < b.primitive || (a.primitive == b.primitive && a.triangle < b.triangle);
  return a.t < b.t || (a.t == b.t && first);
}

// Links left for later, and where the ray enters their boxes. No branches around them: lavapipe runs both sides anyway, and
// two stores under one mask compile to selects where a lone one becomes a branch per lane (1.3 to 1.5 times the speed).
uint meshStack[BVH_DEPTH + 1u];
float meshEnter[BVH_DEPTH + 1u];

// Whether a driver's loop budget ended a traversal before its time: its result is wrong.
bool traversalCut = false;

// Of two children: the nearer one, the farther one for the stack, and how many are met.
struct Order {
  uint next;
  uint later;
  float laterEnter;
  bool both;
  bool none;
};

Order inOrder(float enterA, float enterB, float linkA, float linkB) {
  bool nearerA = enterA <= enterB;
  float farther = nearerA ? enterB : enterA;
  return Order(floatBitsToUint(nearerA ? linkA : linkB), floatBitsToUint(nearerA ? linkB : linkA), farther, farther < INFINITE,
               (nearerA ? enterA : enterB) == INFINITE);
}

// A link from the stack, unless something nearer has been hit since.
uint unlessBeyond(uint link, float enter, float tMax) { return enter >= tMax && link != BVH_END ? BVH_NOTHING : link; }

// A child's 16-bit bounds count from 0, so the ray must too.
float enterChild(BoxRay ray, vec4 child, float tMax) {
  uint x = floatBitsToUint(child.x);
  uint y = floatBitsToUint(child.y);
  uint z = floatBitsToUint(child.z);
  vec3 low = vec3(float(int(x & 0xffffu)), float(int(y & 0xffffu)), float(int(z & 0xffffu)));
  vec3 high = vec3(float(int(x >> 16)), float(int(y >> 16)), float(int(z >> 16)));
  return enterBox(ray, low, high, kAlpha ? passed.t : 0.0, tMax);
}

// The same with branches, and without distances: a GPU skips what it does not need, and its stacks lie in memory.
uint afterNodeBranching(Order o, inout uint height) {
  if (o.both) {
    meshStack[height] = o.later;
    height += 1u;
  }
  if (o.none) height -= 1u;
  return o.none ? meshStack[height] : o.next;
}

// What comes after a node: its nearer child, or what the stack holds.
uint afterNode(uint row, BoxRay ray, float tMax, inout uint height) {
  vec4 a = fetchMesh(row);
  vec4 b = fetchMesh(row + 1u);
  Order o = inOrder(enterChild(ray, a, tMax), enterChild(ray, b, tMax), a.w, b.w);
  if (!kWhileWhile) return afterNodeBranching(o, height);
  uint popped = unlessBeyond(meshStack[height - 1u], meshEnter[height - 1u], tMax);
  meshStack[height] = o.later;
  meshEnter[height] = o.laterEnter;
  height += o.both ? 1u : 0u;
  height -= o.none ? 1u : 0u;
  return o.none ? popped : o.next;
}

void nearerTriangle(inout Hit hit, uint row, vec3 o, Shear shear, uint primitive) {
  TriangleHit found = hitTriangle(o, shear, fetchMesh(row).xyz, fetchMesh(row + 1u).xyz, fetchMesh(row + 2u).xyz);
  bool closer = found.t < hit.t;
  if (kAlpha) {
    Hit here = Hit(found.t, primitive, row);
    bool ofMesh = hit.triangle != 0u;
    closer = (closer || (ofMesh && comesBefore(here, hit))) && comesBefore(passed, here);
  }
  hit.t = closer ? found.t : hit.t;
  hit.primitive = closer ? primitive : hit.primitive;
  hit.triangle = closer ? row : hit.triangle;
}

// The ray in the mesh's grid; `any`: the first triangle found is enough. Starts at link `node`.
void hitMesh(inout Hit hit, LocalRay ray, uint node, uint nodeRow, uint triangleRow, uint primitive, bool any) {
  float tMax = hit.t;
  Shear shear = shearAlong(ray.d);
  BoxRay box = boxRay(ray.o + vec3(BVH_ORIGIN), ray.d, 0.25);
  uint height = 1u;
  meshStack[0] = BVH_END;
  meshEnter[0] = 0.0;
  while (node != BVH_END) {
    if (kWhileWhile) {
      while (node < BVH_LEAF) node = afterNode(nodeRow + node, box, hit.t, height);
      uint row = triangleRow + (node & BVH_FIRST_MASK) * BVH_TRIANGLE_ROWS;
      uint count = node == BVH_END ? 0u : (node & ~BVH_LEAF) >> BVH_COUNT_SHIFT;
      uint end = row + count * BVH_TRIANGLE_ROWS;
      for (; row < end; row += BVH_TRIANGLE_ROWS) nearerTriangle(hit, row, ray.o, shear, primitive);
      height = max(height, 1u) - 1u;
      node = any && hit.t < tMax ? BVH_END : meshStack[height];
    } else if (node < BVH_LEAF) {
      node = afterNode(nodeRow + node, box, hit.t, height);
    } else {
      nearerTriangle(hit, triangleRow + (node & BVH_FIRST_MASK) * BVH_TRIANGLE_ROWS, ray.o, shear, primitive);
      bool more = (node & ~BVH_LEAF) >> BVH_COUNT_SHIFT > 1u;
      height -= more ? 0u : 1u;
      node = more ? node + 1u - (1u << BVH_COUNT_SHIFT) : meshStack[height];
      node = any && hit.t < tMax ? BVH_END : node;
    }
  }
  traversalCut = traversalCut || node != BVH_END;
}

#endif
