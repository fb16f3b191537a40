// SPDX-License-Identifier: MIT
// The point that a ray hit: put back onto the exact surface, with its outward normal.
#ifndef SURFACE_GLSL
#define SURFACE_GLSL
#include "traverse.glsl"

struct Surface {
  vec3 p;       // camera-relative
  vec3 normal;  // geometric, unit, outward
};

// One Newton step along the gradient g of the implicit value f.
vec3 projected(vec3 p, float f, vec3 g) { return p - g * (f / dot(g, g)); }

Surface affineSurface(vec3 p, uint primitive, Layout l) {
  uint row = affineRow(l, primitive);
  vec4 row0 = fetchRow(row);
  vec4 row1 = fetchRow(row + 1u);
  vec4 row2 = fetchRow(row + 2u);
  vec3 q = toUnit(p, p, row0, row1, row2).o;
  vec3 n = vec3(0.0, 1.0, 0.0);
  float f = q.y;
  if (kBoxes && primitive < l.rect) {
    n = boxNormal(q);
    f = dot(n, q) - 1.0;
  } else if (kCylinders && primitive >= l.cylinder && primitive < l.ellipsoid) {
    n = cylinderNormal(q);
    f = n.y != 0.0 ? abs(q.y) - 1.0 : 0.5 * (dot(n, n) - 1.0);
  } else if (kEllipsoids && primitive >= l.ellipsoid) {
    n = q;
    f = 0.5 * (dot(q, q) - 1.0);
    n = nonZero(n);
  }
  vec3 gradient = row0.xyz * n.x + row1.xyz * n.y + row2.xyz * n.z;
  return Surface(projected(p, f, gradient), normalize(gradient));
}

Surface surfaceAt(Ray ray, Hit hit, Layout l) {
  vec3 p = ray.o + ray.d * hit.t;
  vec4 g = fetchRow(kFirstRow + min(hit.primitive, l.largeSphere));
  vec3 toPoint = p - g.xyz;
  vec3 n = normalize(nonZero(toPoint));
  Surface s = Surface(g.xyz + n * g.w, n);
  if (kPlanes) {
    bool plane = hit.primitive >= l.plane;
    vec3 onPlane = p - g.xyz * (dot(g.xyz, p) - g.w);
    s.p = plane ? onPlane : s.p;
    s.normal = plane ? g.xyz : s.normal;
  }
  if (kLargeSpheres && hit.primitive >= l.largeSphere && hit.primitive < l.box) {
    uint row = largeSphereRow(l, hit.primitive);
    vec4 high = fetchRow(row);
    vec4 low = fetchRow(row + 1u);
    s.normal = normalize((p - high.xyz) - low.xyz);
    // centre + radius * n would round to the ulp of the radius; the signed distance does not.
    s.p = p - s.normal * (sphereTermDouble(p, high, low) / (2.0 * high.w));
  }
  if (kAffine && hit.primitive >= l.box && hit.primitive < l.end) s = affineSurface(p, hit.primitive, l);
  return s;
}

#endif
