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
  float x = (float(params.pickX) + 0.5 - 0.5 * float(params.width)) * params.pixelScale;
  float y = (0.5 * float(params.height) - float(params.pickY) - 0.5) * params.pixelScale;
  Ray ray = Ray(vec3(0.0), normalize(camera.right * x + camera.up * y + camera.forward), NO_PRIMITIVE, false);
  Hit hit = closestHit(ray, INFINITE, l);
  bool found = hit.primitive != NO_PRIMITIVE;
  uint primitive = min(hit.primitive, l.end - 1u);
  Surface surface = surfaceAt(ray, Hit(hit.t, primitive), l);
  float object = found ? fetchRow(params.objectRow + primitive).x : uintBitsToFloat(0u);
  bool inside = dot(surface.normal, ray.d) > 0.0;
  picked[0] = vec4(uintBitsToFloat(hit.primitive), object, hit.t, 0.0);
  picked[1] = vec4(surface.p, 0.0);
  picked[2] = vec4(inside ? -surface.normal : surface.normal, 0.0);
}
