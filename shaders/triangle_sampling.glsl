// SPDX-License-Identifier: MIT
// Directions from a point to a glowing triangle, uniform in the solid angle under which the point sees it. Binding-free.
#ifndef TRIANGLE_SAMPLING_GLSL
#define TRIANGLE_SAMPLING_GLSL
#include "light_sampling.glsl"

// A triangle as a point sees it.
struct TriangleView {
  vec3 corner;  // from the point
  vec3 edge1;
  vec3 edge2;
  float solidAngle;
};

TriangleView triangleView(vec3 corner, vec3 edge1, vec3 edge2) {
  vec3 b = corner + edge1;
  vec3 c = corner + edge2;
  float ia = inversesqrt(max(dot(corner, corner), 1e-36));
  float ib = inversesqrt(max(dot(b, b), 1e-36));
  float ic = inversesqrt(max(dot(c, c), 1e-36));
  float product = abs(dot(corner * ia, cross(edge1 * ib, edge2 * ic)));
  return TriangleView(corner, edge1, edge2, 2.0 * halfSolidAngle(corner * ia, b * ib, c * ic, product));
}

// Half the normal, as long as the area.
vec3 areaOf(TriangleView view) { return cross(view.edge1, view.edge2) * 0.5; }

struct TriangleSample {
  vec3 toPoint;
  vec3 weights;  // of the corners
  float pdf;     // per solid angle
};

TriangleSample sampleTriangle(TriangleView view, float u, float v) {
  bool area = sampledByArea(view.solidAngle);
  float turns = 0.25 / PI * view.solidAngle;
  float near = cosSinTurn(u * turns).s;
  float far = cosSinTurn((1.0 - u) * turns).s;
  vec3 a = view.corner;
  vec2 byAngle = placeInTriangle(a, a + view.edge1, a + view.edge2, near, far, v);
  vec2 place = area ? vec2(v, sqrt(clamp(u, 0.0, 1.0))) : byAngle;
  vec3 weights = vec3(1.0 - place.y, place.y * (1.0 - place.x), place.y * place.x);
  vec3 toPoint = a + (view.edge1 * weights.y + view.edge2 * weights.z);
  float byArea = towardsPoint(toPoint, areaOf(view)).pdf;
  return TriangleSample(toPoint, weights, area ? byArea : 1.0 / view.solidAngle);
}

// Density of sampleTriangle() for a direction that meets the triangle.
float trianglePdf(TriangleView view, vec3 wi) {
  return sampledByArea(view.solidAngle) ? areaPdf(view.corner, areaOf(view), wi) : 1.0 / view.solidAngle;
}

#endif
