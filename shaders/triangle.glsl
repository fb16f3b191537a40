// SPDX-License-Identifier: MIT
// Ray against triangle and box without leaks: a ray that meets the edge or the vertex of a closed mesh meets one of the
// triangles there (Woop, Benthin & Wald, Watertight ray/triangle intersection, JCGT 2(1), 2013; Ize, Robust BVH ray
// traversal, JCGT 2(2), 2013). Binding-free.
#ifndef TRIANGLE_GLSL
#define TRIANGLE_GLSL
#include "numerics.glsl"

// Turns space so that the ray runs along the last axis, from the origin: the largest component of d becomes the last one,
// then a shear takes the others away.
struct Shear {
  bool x;  // which component is the largest; neither = z
  bool y;
  vec3 s;  // what to take away from the others, and 1 / the largest
};

Shear shearAlong(vec3 d) {
  vec3 a = abs(d);
  bool x = a.x > a.y && a.x > a.z;
  bool y = !x && a.y > a.z;
  vec3 p = x ? vec3(d.y, d.z, d.x) : (y ? vec3(d.z, d.x, d.y) : d);
  float inverse = 1.0 / p.z;
  return Shear(x, y, vec3(p.x * inverse, p.y * inverse, inverse));
}

// A vertex relative to the ray's origin, sheared; its last component is the distance in units of d. `precise`: a vertex must
// land at the same place for every triangle that has it.
vec3 sheared(Shear shear, vec3 v) {
  vec3 p = shear.x ? vec3(v.y, v.z, v.x) : (shear.y ? vec3(v.z, v.x, v.y) : v);
  precise float x = p.x - shear.s.x * p.z;
  precise float y = p.y - shear.s.y * p.z;
  precise float z = shear.s.z * p.z;
  return vec3(x, y, z);
}

// Weights of the vertices (not normalized) and the distance, INFINITE = miss.
struct TriangleHit {
  vec3 weights;
  float t;
};

// Twice the signed area of the triangle with the origin. Rounding a product never changes the order of two products, so the
// rounded difference has the right sign or is 0, and its neighbour's edge sees exactly the negative: with 0 taken as inside no
// ray gets lost between two triangles. (The paper decides a 0 in double, which only tells which of the two is hit.)
float edgeFunction(vec3 a, vec3 b) {
  precise float p = a.x * b.y;
  precise float q = a.y * b.x;
  precise float e = p - q;
  return e;
}

TriangleHit hitTriangle(vec3 o, Shear shear, vec3 v0, vec3 v1, vec3 v2) {
  vec3 a = sheared(shear, v0 - o);
  vec3 b = sheared(shear, v1 - o);
  vec3 c = sheared(shear, v2 - o);
  float u = edgeFunction(c, b);
  float v = edgeFunction(a, c);
  float w = edgeFunction(b, a);
  float det = u + v + w;
  float t = (u * a.z + v * b.z + w * c.z) / det;
  bool inside = lesser(u, lesser(v, w)) >= 0.0 || greater(u, greater(v, w)) <= 0.0;
  bool hit = inside && det != 0.0 && t > 0.0;
  return TriangleHit(vec3(u, v, w), hit ? t : INFINITE);
}

// A ray as boxes see it: t = plane * inverse - low for lower planes, - high for upper ones. The planes are moved outward by
// what rounding can do to the ray and to the triangle test, so that no box is missed whose triangle would be hit.
struct BoxRay {
  vec3 inverse;
  vec3 low;
  vec3 high;
};

float inverseOf(float d) { return 1.0 / (abs(d) < 1e-20 ? (d < 0.0 ? -1e-20 : 1e-20) : d); }

// `margin`: least distance that planes move outward.
BoxRay boxRay(vec3 o, vec3 d, float margin) {
  vec3 inverse = vec3(inverseOf(d.x), inverseOf(d.y), inverseOf(d.z));
  // Vertices round relative to the distance from o, the shear and the test by some units in the last place of that.
  float e = margin + 4e-7 * maxComponent(abs(o));
  return BoxRay(inverse, (o + vec3(e)) * inverse, (o - vec3(e)) * inverse);
}

// Where the ray enters the box, or INFINITE when it does not between tMin and tMax.
float enterBox(BoxRay ray, vec3 low, vec3 high, float tMin, float tMax) {
  vec3 a = low * ray.inverse - ray.low;
  vec3 b = high * ray.inverse - ray.high;
  float enter = greater(greater(lesser(a.x, b.x), lesser(a.y, b.y)), greater(lesser(a.z, b.z), tMin));
  float leave = lesser(lesser(greater(a.x, b.x), greater(a.y, b.y)), lesser(greater(a.z, b.z), tMax));
  return enter <= leave ? enter : INFINITE;
}

#endif
