// SPDX-License-Identifier: MIT
// The scene on the device: one texel buffer of vec4 rows (layout in gpu_types.h) and how its records unpack.
#ifndef SCENE_GLSL
#define SCENE_GLSL
#include "bsdf.glsl"
#include "features.glsl"

layout(set = 0, binding = 0) uniform samplerBuffer sceneRows;
layout(push_constant) uniform Push { TraceParams params; };

layout(set = 0, binding = 8) uniform samplerBuffer tableRows;

vec4 fetchRow(uint row) { return texelFetch(sceneRows, int(row)); }
vec4 fetchTable(uint row) { return texelFetch(tableRows, int(row)); }

// First primitive index and first row of each kind, in upload order.
struct Layout {
  uint plane, largeSphere, box, rect, disk, cylinder, ellipsoid, end;
};

uint sphereCount() { return kFixedSpheres > 0u ? kFixedSpheres : params.sphereCount; }
uint planeCount() { return kFixedPlanes > 0u ? kFixedPlanes : params.planeCount; }
uint lightCount() { return kFixedLights > 0u ? kFixedLights : params.lightCount; }

Layout primitiveLayout() {
  Layout l;
  l.plane = sphereCount();
  l.largeSphere = l.plane + planeCount();
  l.box = l.largeSphere + params.largeSphereCount;
  l.rect = l.box + params.boxCount;
  l.disk = l.rect + params.rectCount;
  l.cylinder = l.disk + params.diskCount;
  l.ellipsoid = l.cylinder + params.cylinderCount;
  l.end = l.ellipsoid + params.ellipsoidCount;
  return l;
}

const uint kFirstRow = CAMERA_ROWS + FILTER_ROWS;
uint largeSphereRow(Layout l, uint primitive) {
  return kFirstRow + l.largeSphere + (primitive - l.largeSphere) * LARGE_SPHERE_ROWS;
}
uint affineRow(Layout l, uint primitive) {
  return kFirstRow + l.largeSphere + (l.box - l.largeSphere) * LARGE_SPHERE_ROWS + (primitive - l.box) * AFFINE_ROWS;
}

#endif
