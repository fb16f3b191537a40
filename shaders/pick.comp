#version 460
// SPDX-License-Identifier: MIT
// What is under one pixel: the ray through its centre, the same traversal as the tracer's.
#extension GL_GOOGLE_include_directive : require
#include "camera.glsl"
#include "surface.glsl"

layout(local_size_x = 1) in;
layout(set = 0, binding = 7) buffer Picked { vec4 picked[]; };

void main() {
  Layout l = primitiveLayout();
  CameraRows camera = fetchCamera();
  loadBakedPrimitives();
  // Through the middle of the lens, which sees all depths sharply.
  CameraRay seen = cameraRay(camera, float(params.pickX) + 0.5, float(params.pickY) + 0.5, 0.0, 0.0);
  Ray ray = Ray(seen.o, seen.d, NO_PRIMITIVE, false);
  Hit hit = closestHit(ray, INFINITE, l);
  bool found = hit.primitive != NO_PRIMITIVE;
  uint primitive = min(hit.primitive, l.end - 1u);
  Surface surface = surfaceAt(ray, Hit(hit.t, primitive, hit.triangle), l);
  float object = found ? fetchRow(params.objectRow + primitive).x : uintBitsToFloat(0u);
  bool inside = dot(surface.normal, ray.d) > 0.0;
  picked[0] = vec4(uintBitsToFloat(hit.primitive), object, hit.t, 0.0);
  picked[1] = vec4(surface.p, 0.0);
  picked[2] = vec4(inside ? -surface.normal : surface.normal, 0.0);
}
