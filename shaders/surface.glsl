// SPDX-License-Identifier: MIT
// The point that a ray hit: put back onto the exact surface, with its outward normal.
#ifndef SURFACE_GLSL
#define SURFACE_GLSL
#include "traverse.glsl"

struct Surface {
  vec3 p;       // camera-relative
  vec3 normal;  // geometric, unit, outward
  float offset;  // along the normal, that a new ray needs to leave the surface for sure; 0 where shapes know their own rays
  vec3 weights;  // of the triangle's vertices, for meshes
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
  } else if (kEllipsoids && primitive >= l.ellipsoid && primitive < l.instance) {
    n = q;
    f = 0.5 * (dot(q, q) - 1.0);
    n = nonZero(n);
  }
  vec3 gradient = row0.xyz * n.x + row1.xyz * n.y + row2.xyz * n.z;
  return Surface(projected(p, f, gradient), normalize(gradient), 0.0, vec3(0.0));
}

vec3 timesRows(vec4 row0, vec4 row1, vec4 row2, vec3 v) {
  return vec3(dot(row0.xyz, v), dot(row1.xyz, v), dot(row2.xyz, v));
}

// The point by its weights, which does not depend on the length of the ray; and how far rounding may have put it, and the
// next ray's start, off the triangle: the last digits of the place in the world, and those of the triangle test in the mesh
// (after NVIDIA's Self-Intersection Avoidance, 2023).
Surface meshSurface(Ray ray, Hit hit, Layout l) {
  uint row = instanceRow(l, hit.primitive);
  vec4 row0 = fetchRow(row);
  vec4 row1 = fetchRow(row + 1u);
  vec4 row2 = fetchRow(row + 2u);
  vec3 centre = vec3(row0.w, row1.w, row2.w);
  vec3 v0 = fetchMesh(hit.triangle).xyz;
  vec3 v1 = fetchMesh(hit.triangle + 1u).xyz;
  vec3 v2 = fetchMesh(hit.triangle + 2u).xyz;
  vec3 edge1 = v1 - v0;
  vec3 edge2 = v2 - v0;
  LocalRay local = toUnit(ray.o, ray.d, row0, row1, row2);
  vec3 weights = hitTriangle(local.o, shearAlong(local.d), v0, v1, v2).weights;
  weights = weights / (weights.x + weights.y + weights.z);
  vec3 q = v0 + edge1 * weights.y + edge2 * weights.z;
  vec3 offCentre = timesRows(fetchRow(row + 4u), fetchRow(row + 5u), fetchRow(row + 6u), q);
  vec3 p = centre + offCentre;
  vec3 n = cross(edge1, edge2);
  vec3 gradient = row0.xyz * n.x + row1.xyz * n.y + row2.xyz * n.z;
  float inverseLength = inversesqrt(dot(gradient, gradient));
  vec3 normal = gradient * inverseLength;
  // The test's distance is off by digits of the largest extent, whatever the axis.
  vec3 inMesh = abs(v0) + vec3(maxComponent(abs(edge1) + abs(edge2))) + timesRows(abs(row0), abs(row1), abs(row2), abs(offCentre));
  float offset = 4e-7 * (dot(abs(normal), abs(p)) + dot(abs(n), inMesh) * inverseLength);
  return Surface(p, normal, offset, weights);
}

Surface surfaceAt(Ray ray, Hit hit, Layout l) {
  vec3 p = ray.o + ray.d * hit.t;
  vec4 g = fetchRow(kFirstRow + min(hit.primitive, l.largeSphere));
  vec3 toPoint = p - g.xyz;
  vec3 n = unit(nonZero(toPoint));
  Surface s = Surface(g.xyz + n * g.w, n, 0.0, vec3(0.0));
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
  if (kAffine && hit.primitive >= l.box && hit.primitive < l.instance) s = affineSurface(p, hit.primitive, l);
  if (kMeshes && hit.primitive >= l.instance && hit.primitive < l.end) s = meshSurface(ray, hit, l);
  return s;
}

#endif
