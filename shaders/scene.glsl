// SPDX-License-Identifier: MIT
// The scene on the device: one texel buffer of vec4 rows (layout in gpu_types.h) and how its records unpack.
#ifndef SCENE_GLSL
#define SCENE_GLSL
#include "bsdf.glsl"
#include "features.glsl"

layout(set = 0, binding = 0) uniform samplerBuffer sceneRows;
// Read once, at the top of main: some drivers fetch a push constant for each lane whenever it is named.
layout(push_constant) uniform Push { TraceParams pushed; }; TraceParams params = pushed;

layout(set = 0, binding = 8) uniform samplerBuffer tableRows;

vec4 fetchRow(uint row) { return texelFetch(sceneRows, int(row)); }
layout(set = 0, binding = 9) uniform samplerBuffer meshRows;
layout(set = 0, binding = 10) uniform usamplerBuffer texels;

vec4 fetchMesh(uint row) { return texelFetch(meshRows, int(row)); }
uint fetchTexel(uint at) { return texelFetch(texels, int(at)).x; }
vec4 fetchTable(uint row) { return texelFetch(tableRows, int(row)); }

// First primitive index and first row of each kind, in upload order.
struct Layout {
  uint plane, largeSphere, box, rect, disk, cylinder, ellipsoid, instance, end;
};

uint sphereCount() { return kFixedSpheres > 0u ? kFixedSpheres : params.sphereCount; }
uint planeCount() { return kFixedPlanes > 0u ? kFixedPlanes : params.planeCount; }
uint lightCount() { return kFixedLights > 0u ? kFixedLights : params.lightCount; }

Layout primitiveLayout() {
  Layout l;
  l.plane = sphereCount();
  l.largeSphere = l.plane + planeCount();
  l.box = l.largeSphere + (kLargeSpheres ? params.largeSphereCount : 0u);
  l.rect = l.box + (kBoxes ? params.boxCount : 0u);
  l.disk = l.rect + (kRects ? params.rectCount : 0u);
  l.cylinder = l.disk + (kDisks ? params.diskCount : 0u);
  l.ellipsoid = l.cylinder + (kCylinders ? params.cylinderCount : 0u);
  l.instance = l.ellipsoid + (kEllipsoids ? params.ellipsoidCount : 0u);
  l.end = l.instance + (kMeshes ? params.instanceCount : 0u);
  return l;
}

const uint kFirstRow = CAMERA_ROWS + FILTER_ROWS;
uint largeSphereRow(Layout l, uint primitive) {
  return kFirstRow + l.largeSphere + (primitive - l.largeSphere) * LARGE_SPHERE_ROWS;
}
uint affineRow(Layout l, uint primitive) {
  return kFirstRow + l.largeSphere + (l.box - l.largeSphere) * LARGE_SPHERE_ROWS + (primitive - l.box) * AFFINE_ROWS;
}
uint instanceRow(Layout l, uint primitive) {
  return affineRow(l, l.instance) + (primitive - l.instance) * INSTANCE_ROWS;
}

#endif
