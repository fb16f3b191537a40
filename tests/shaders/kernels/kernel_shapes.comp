#version 460
// SPDX-License-Identifier: MIT
// shapes.glsl: one ray against one shape. Rows: (o, self) (d, selfInside) and three rows of the shape.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "shapes.glsl"

void main() {
  uint at = 5u * invocation();
  vec4 a = questions[at];
  vec4 b = questions[at + 1u];
  vec4 row0 = questions[at + 2u];
  vec4 row1 = questions[at + 3u];
  vec4 row2 = questions[at + 4u];
  bool self = a.w != 0.0;
  bool inside = b.w != 0.0;
  LocalRay ray = toUnit(a.xyz, b.xyz, row0, row1, row2);
  float t = 0.0;
  if (kOperation == 0u) t = hitSphere(a.xyz, b.xyz, row0.xyz, row0.w, self, inside);
  else if (kOperation == 1u) t = hitLargeSphere(a.xyz, b.xyz, row0, row1, self, inside);
  else if (kOperation == 2u) t = hitPlane(planeTerms(a.xyz, b.xyz, row0), self);
  else if (kOperation == 3u) t = hitBox(ray, self, inside);
  else if (kOperation == 4u) t = hitRect(ray, self);
  else if (kOperation == 5u) t = hitDisk(ray, self);
  else if (kOperation == 6u) t = hitCylinder(ray, self, inside);
  else if (kOperation == 7u) t = hitEllipsoid(ray, self, inside);
  else t = sphereTermDouble(a.xyz, row0, row1);
  answers[invocation()] = vec4(t, 0.0, 0.0, 0.0);
}
