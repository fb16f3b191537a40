// SPDX-License-Identifier: MIT
// Ray against analytic shapes. Distances are in units of the direction's length; INFINITE = miss. Binding-free.
// `self`: the ray starts on this very primitive, which then uses an exact rule instead of an epsilon.
#ifndef SHAPES_GLSL
#define SHAPES_GLSL
#include "numerics.glsl"

// Slabs are enlarged by 2 * gamma(3) so that flat boxes stay hit (Ize, JCGT 2(2), 2013).
const float SLAB_ENLARGE = 1.00000036;

// Nearest positive root of t^2 + 2 b t + c = 0, given sqrt(b^2 - c): the two roots never cancel (Press et al.).
float nearestRoot(float b, float c, float root) {
  float q = b < 0.0 ? root - b : -b - root;
  float other = c / q;
  float entering = c > 0.0 ? other : q;
  float leaving = c < 0.0 ? other : INFINITE;
  return b < 0.0 ? entering : leaving;
}

// b^2 - c without cancellation: directly while c is small beside b^2, else by the distance of closest approach
// (Hearn & Baker; Haines et al., Ray Tracing Gems ch. 7, 2019).
float hybridDiscriminant(float b, float c, float r2, float approach2) {
  return abs(c) < 0.5 * b * b ? b * b - c : r2 - approach2;
}

// Where a ray leaves the sphere it starts on: roots 0 and -2b, exactly, and only from the inside. The sign of b is not
// trusted: at a grazing angle rounding flips it, which would be a self hit outside and a leak inside.
float ownSphere(float b, bool selfInside) { return selfInside ? max(-2.0 * b, 0.0) : INFINITE; }

// The quadratic t^2 + 2 b t + c = 0 of a ray and a sphere, and the squared distance of closest approach.
struct SphereTerms {
  float b;
  float c;
  float r2;
  float approach2;
};

SphereTerms sphereTerms(vec3 o, vec3 d, vec3 centre, float radius) {
  vec3 f = o - centre;
  float b = dot(f, d);
  float r2 = radius * radius;
  vec3 l = f - d * b;
  return SphereTerms(b, dot(f, f) - r2, r2, dot(l, l));
}

// Unit direction d.
float hitSphere(vec3 o, vec3 d, vec3 centre, float radius, bool self, bool selfInside) {
  SphereTerms q = sphereTerms(o, d, centre, radius);
  float disc = hybridDiscriminant(q.b, q.c, q.r2, q.approach2);
  float t = nearestRoot(q.b, q.c, sqrt(max(disc, 0.0)));
  return self ? ownSphere(q.b, selfInside) : (disc > 0.0 ? t : INFINITE);
}

// Whether the segment (0, tMax) crosses the sphere: no root is needed, so no square root and no division. From outside
// to outside it must pass the closest approach inside; otherwise one end is inside and the other is not. Whether the approach
// is inside, both discriminants tell equally well: where b^2 - c has lost no digits, the approach has none to lose.
bool blocksSphere(vec3 o, vec3 d, float tMax, vec3 centre, float radius, bool self, bool selfInside) {
  SphereTerms q = sphereTerms(o, d, centre, radius);
  bool startInside = q.c < 0.0;
  bool endInside = q.c + tMax * (2.0 * q.b + tMax) < 0.0;
  bool through = !startInside && q.b < 0.0 && tMax + q.b > 0.0 && q.approach2 < q.r2;
  bool own = selfInside && -2.0 * q.b < tMax;
  return self ? own : (startInside != endInside || through);
}

// |o - centre|^2 - radius^2 in double-float: what a planet-sized sphere under a small camera needs.
float sphereTermDouble(vec3 o, vec4 high, vec4 low) {
  DoubleFloat x = addDouble(twoSum(o.x, -high.x), DoubleFloat(-low.x, 0.0));
  DoubleFloat y = addDouble(twoSum(o.y, -high.y), DoubleFloat(-low.y, 0.0));
  DoubleFloat z = addDouble(twoSum(o.z, -high.z), DoubleFloat(-low.z, 0.0));
  DoubleFloat r2 = squareDouble(DoubleFloat(high.w, low.w));
  DoubleFloat sum = addDouble(addDouble(squareDouble(x), squareDouble(y)), squareDouble(z));
  DoubleFloat c = addDouble(sum, DoubleFloat(-r2.hi, -r2.lo));
  return c.hi + c.lo;
}

// Sphere whose centre and radius are double-floats (high + low).
float hitLargeSphere(vec3 o, vec3 d, vec4 high, vec4 low, bool self, bool selfInside) {
  vec3 f = (o - vec3(high.x, high.y, high.z)) - vec3(low.x, low.y, low.z);
  float b = dot(f, d);
  float c = sphereTermDouble(o, high, low);
  vec3 l = f - d * b;
  float disc = hybridDiscriminant(b, c, high.w * high.w, dot(l, l));
  float t = nearestRoot(b, c, sqrt(max(disc, 0.0)));
  return self ? ownSphere(b, selfInside) : (disc > 0.0 ? t : INFINITE);
}

// A plane as a ray sees it: its height above the ray's start, and above the tip of the direction's arrow less that. Both
// change sign with the normal, which no answer depends on.
struct PlaneTerms {
  float height;
  float along;
};

// How far a plane (unit normal, D, computed in double on the host) lies above p.
float planeHeight(vec3 p, vec4 plane) { return plane.w - dot(p, vec3(plane.x, plane.y, plane.z)); }

PlaneTerms planeTerms(vec3 o, vec3 d, vec4 plane) {
  return PlaneTerms(planeHeight(o, plane), dot(d, vec3(plane.x, plane.y, plane.z)));
}

// Only an exactly parallel ray misses. By the reciprocal, which opposite walls share.
float hitPlane(PlaneTerms q, bool self) {
  float t = q.height * (1.0 / q.along);
  return q.along != 0.0 && t > 0.0 && !self ? t : INFINITE;
}

// Whether the plane lies within (0, tMax), without the division.
bool blocksPlane(PlaneTerms q, float tMax, bool self) {
  return q.height * q.along > 0.0 && abs(q.height) < tMax * abs(q.along) && !self;
}

// An object-space ray of an affine shape: o - centre first, then the 3x3, so that far centres cost nothing.
struct LocalRay {
  vec3 o;
  vec3 d;
};

LocalRay toUnit(vec3 o, vec3 d, vec4 row0, vec4 row1, vec4 row2) {
  vec3 p = o - vec3(row0.w, row1.w, row2.w);
  vec3 r0 = vec3(row0.x, row0.y, row0.z);
  vec3 r1 = vec3(row1.x, row1.y, row1.z);
  vec3 r2 = vec3(row2.x, row2.y, row2.z);
  return LocalRay(vec3(dot(r0, p), dot(r1, p), dot(r2, p)), vec3(dot(r0, d), dot(r1, d), dot(r2, d)));
}

// A convex solid's [enter, leave]: from outside the entry, from inside the exit; on the solid itself only an exit. A ray
// from its inside always has one: at an edge, rounding may put the start behind the next face, which is met at once.
float convexHit(float enter, float leave, bool self, bool selfInside) {
  bool hit = enter <= leave;
  float outside = enter > 0.0 ? enter : (leave > 0.0 ? leave : INFINITE);
  float own = selfInside ? max(leave, 0.0) : INFINITE;
  return self ? own : (hit ? outside : INFINITE);
}

// [enter, leave] of the slab |x| <= 1. A direction of 0 would give 0 * inf = NaN in the slab's own plane.
vec2 slabInterval(float o, float d) {
  bool parallel = abs(d) < 1e-20;
  float inv = 1.0 / (parallel ? 1.0 : d);
  float a = (-1.0 - o) * inv;
  float b = (1.0 - o) * inv;
  float outside = abs(o) <= 1.0 ? -INFINITE : INFINITE;
  return vec2(parallel ? outside : min(a, b), parallel ? -outside : max(a, b));
}

// Unit box [-1, 1]^3.
float hitBox(LocalRay r, bool self, bool selfInside) {
  vec2 x = slabInterval(r.o.x, r.d.x);
  vec2 y = slabInterval(r.o.y, r.d.y);
  vec2 z = slabInterval(r.o.z, r.d.z);
  float enter = max(x.x, max(y.x, z.x));
  float leave = min(x.y, min(y.y, z.y));
  // A scaled |leave| keeps the enlargement outward on both sides of 0.
  return convexHit(enter, leave + abs(leave) * (SLAB_ENLARGE - 1.0), self, selfInside);
}

// Unit rectangle |x|, |z| <= 1 in y = 0.
float hitRect(LocalRay r, bool self) {
  float t = -r.o.y / r.d.y;
  float x = r.o.x + t * r.d.x;
  float z = r.o.z + t * r.d.z;
  return r.d.y != 0.0 && t > 0.0 && abs(x) <= 1.0 && abs(z) <= 1.0 && !self ? t : INFINITE;
}

// Unit disk x^2 + z^2 <= 1 in y = 0.
float hitDisk(LocalRay r, bool self) {
  float t = -r.o.y / r.d.y;
  float x = r.o.x + t * r.d.x;
  float z = r.o.z + t * r.d.z;
  return r.d.y != 0.0 && t > 0.0 && x * x + z * z <= 1.0 && !self ? t : INFINITE;
}

// Unit cylinder x^2 + z^2 <= 1, |y| <= 1, capped: the infinite tube's interval cut by the slab's.
float hitCylinder(LocalRay r, bool self, bool selfInside) {
  float a = r.d.x * r.d.x + r.d.z * r.d.z;
  float b = r.o.x * r.d.x + r.o.z * r.d.z;
  float c = r.o.x * r.o.x + r.o.z * r.o.z - 1.0;
  float cross = r.o.x * r.d.z - r.o.z * r.d.x;
  float disc = abs(a * c) < 0.5 * b * b ? b * b - a * c : a - cross * cross;
  float q = b < 0.0 ? sqrt(max(disc, 0.0)) - b : -b - sqrt(max(disc, 0.0));
  float root0 = c / q;
  float root1 = q / a;
  float enter = min(root0, root1);
  float leave = max(root0, root1);
  bool axial = a < 1e-20 * r.d.y * r.d.y;
  enter = axial ? (c <= 0.0 ? -INFINITE : INFINITE) : enter;
  leave = axial ? (c <= 0.0 ? INFINITE : -INFINITE) : leave;
  vec2 caps = slabInterval(r.o.y, r.d.y);
  enter = max(enter, caps.x);
  leave = min(leave, caps.y);
  float t = convexHit(enter, leave, self, selfInside);
  return axial || disc > 0.0 ? t : INFINITE;
}

// Unit sphere seen through an affine map: an ellipsoid. d has any length.
float hitEllipsoid(LocalRay r, bool self, bool selfInside) {
  float scale = inversesqrt(dot(r.d, r.d));
  float t = hitSphere(r.o, r.d * scale, vec3(0.0), 1.0, self, selfInside);
  return t < INFINITE ? t * scale : INFINITE;
}

// A shape too small for the digits of its place is hit at its centre, where it has no direction: take any.
vec3 nonZero(vec3 n) { return dot(n, n) > 1e-36 ? n : vec3(1.0, 0.0, 0.0); }
float side(float x) { return x < 0.0 ? -1.0 : 1.0; }

// Outward normals of the unit shapes at a point on them (not normalized).
vec3 boxNormal(vec3 p) {
  vec3 a = abs(p);
  bool x = a.x >= a.y && a.x >= a.z;
  bool y = !x && a.y >= a.z;
  return vec3(x ? side(p.x) : 0.0, y ? side(p.y) : 0.0, !x && !y ? side(p.z) : 0.0);
}

vec3 cylinderNormal(vec3 p) {
  bool cap = abs(p.y) - 1.0 > 0.5 * (p.x * p.x + p.z * p.z - 1.0);
  return cap ? vec3(0.0, side(p.y), 0.0) : nonZero(vec3(p.x, 0.0, p.z));
}

#endif
