#version 460
// SPDX-License-Identifier: MIT
// traverse.glsl, surface.glsl and lights.glsl on scene rows: a hit and its surface, the bounce after it, a light.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "camera.glsl"
#include "lights.glsl"
#include "random.glsl"
#include "surface.glsl"

// (o, -) (d, -) -> (t, primitive or -1, inside, -) (p, -) (normal, -).
void answerHit(uint at, Hit hit, Surface surface, bool inside) {
  bool found = hit.primitive != NO_PRIMITIVE;
  answers[3u * at] = vec4(found ? hit.t : INFINITE, found ? float(hit.primitive) : -1.0, inside ? 1.0 : 0.0, 0.0);
  answers[3u * at + 1u] = vec4(surface.p, 0.0);
  answers[3u * at + 2u] = vec4(surface.normal, 0.0);
}

void main() {
  uint at = invocation();
  Layout l = primitiveLayout();
  loadBakedPrimitives();
  if (kOperation == 2u) {
    LightSample s = sampleLight(fetchLight(uint(questions[at].w)), questions[at].xyz, 0.5, 0.5);
    answers[2u * at] = vec4(s.wi, s.distance);
    answers[2u * at + 1u] = vec4(s.illuminance, 0.0);
    return;
  }
  if (kOperation == 3u) {
    vec4 q = questions[at];
    answers[at] = vec4(filteredCameraRay(fetchCamera(), uvec2(q.xy), q.z, q.w, 0.0, 0.0).d, filterOffset(q.z));
    return;
  }
  Ray ray = Ray(questions[2u * at].xyz, questions[2u * at + 1u].xyz, NO_PRIMITIVE, false);
  Hit hit = closestHit(ray, INFINITE, l);
  Surface surface = surfaceAt(ray, Hit(hit.t, min(hit.primitive, l.end - 1u), hit.triangle), l);
  bool inside = dot(surface.normal, ray.d) > 0.0;
  if (kOperation == 1u) {
    // The bounce: a cosine-distributed ray from the surface, which knows where it starts.
    Frame frame = frameAround(inside ? -surface.normal : surface.normal);
    float v = sampleIndependent(0x1b873593u, at, 0u);
    vec3 local = cosineHemisphere(cos(2.0 * PI * v), sin(2.0 * PI * v), sampleIndependent(0x1b873593u, at, 1u));
    Ray next = Ray(surface.p, toWorld(frame, local), min(hit.primitive, l.end - 1u), inside);
    Hit again = closestHit(next, INFINITE, l);
    bool found = hit.primitive != NO_PRIMITIVE;
    bool foundAgain = again.primitive != NO_PRIMITIVE;
    answers[at] = vec4(found ? hit.t : INFINITE, foundAgain ? again.t : INFINITE, inside ? 1.0 : 0.0, local.z);
    return;
  }
  answerHit(at, hit, surface, inside);
}
