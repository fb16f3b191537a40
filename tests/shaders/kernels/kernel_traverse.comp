#version 460
// SPDX-License-Identifier: MIT
// traverse.glsl on a whole scene: the nearest hit of a ray with the surface there, or whether its segment is free.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "surface.glsl"

uint indexOf(float number) { return number < 0.0 ? NO_PRIMITIVE : uint(number); }

// (o, tMax) (d, 1 = to the inside of self) (self or -1, target or -1, -, -) -> 0: (point, t) (normal, primitive or -1),
// 1: (1 = blocked, -, -, -) (-); 2: the same on the way to a light that is a point, whose place stands for d.
void main() {
  uint at = invocation();
  Layout l = primitiveLayout();
  loadBakedPrimitives();
  vec4 o = questions[3u * at];
  vec4 d = questions[3u * at + 1u];
  vec4 who = questions[3u * at + 2u];
  Ray ray = Ray(o.xyz, d.xyz, indexOf(who.x), d.w != 0.0);
  ShadowEnd end = unplaced(o.w);
  if (kOperation == 2u) {
    ray.d = unit(d.xyz - o.xyz);
    end = ShadowEnd(length(d.xyz - o.xyz), d.xyz, true);
  }
  if (kOperation != 0u) {
    answers[2u * at] = vec4(occluded(ray, end, indexOf(who.y), l) ? 1.0 : 0.0, traversalCut ? 1.0 : 0.0, 0.0, 0.0);
    answers[2u * at + 1u] = vec4(0.0);
    return;
  }
  Hit hit = closestHit(ray, o.w, l);
  Surface surface = surfaceAt(ray, Hit(hit.t, min(hit.primitive, l.end - 1u), hit.triangle), l);
  bool found = hit.primitive != NO_PRIMITIVE;
  answers[2u * at] = vec4(surface.p, hit.t);
  answers[2u * at + 1u] = vec4(surface.normal, found ? float(hit.primitive) : (traversalCut ? -2.0 : -1.0));
}
