#version 460
// SPDX-License-Identifier: MIT
// Adds what samples [sampleBegin, sampleEnd) of rows [rowBegin, rowEnd) see first: the paths' own camera rays, so that
// edges are as soft, and what is out of focus as blurred, as in the picture. The object id is that of the pixel's centre.
#extension GL_GOOGLE_include_directive : require
#include "path.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 1) buffer Albedo { vec4 albedoSum[]; };  // albedo, hits
layout(set = 0, binding = 2) buffer Normal { vec4 normalSum[]; };  // normal towards the viewer, distance
layout(set = 0, binding = 3) buffer Object { uint objectId[]; };
layout(set = 0, binding = 5) buffer Counters { uint counters[COUNTERS]; };

uint objectAt(CameraRows camera, uvec2 pixel, Layout l) {
  CameraRay seen = cameraRay(camera, float(pixel.x) + 0.5, float(pixel.y) + 0.5, 0.0, 0.0);
  Hit hit = closestHit(Ray(seen.o, seen.d, NO_PRIMITIVE, false), INFINITE, l);
  uint id = floatBitsToUint(fetchRow(params.objectRow + min(hit.primitive, l.end - 1u)).x);
  return hit.primitive != NO_PRIMITIVE ? id : 0u;
}

void main() {
  uvec2 pixel = uvec2(gl_GlobalInvocationID.x, params.rowBegin + gl_GlobalInvocationID.y);
  if (pixel.x >= params.width || pixel.y >= params.rowEnd) return;
  uint at = pixel.y * params.width + pixel.x;
  Layout l = primitiveLayout();
  CameraRows camera = fetchCamera();
  loadBakedPrimitives();
  uint seed = pixelSeedOf(pixel.x, pixel.y, 0u, params.seed);
  vec4 albedo = vec4(0.0);
  vec4 normal = vec4(0.0);
  for (uint index = params.sampleBegin; index < params.sampleEnd; ++index) {
    Path path = cameraPath(camera, pixel, pairAt(seed, index, 0u), seed, index);
    Hit hit = nextHit(path, seed, l);
    float found = hit.primitive != NO_PRIMITIVE ? 1.0 : 0.0;
    uint primitive = min(hit.primitive, l.end - 1u);
    Vertex v = vertexAt(Hit(found > 0.0 ? hit.t : 1.0, primitive, hit.triangle), path, seed, l);
    vec4 color = vec4(v.material.albedo, 1.0);
    albedo += found > 0.0 ? color : vec4(0.0);
    normal += found > 0.0 ? vec4(v.frame.n, hit.t) : vec4(0.0);
  }
  if (params.sampleBegin == 0u) objectId[at] = objectAt(camera, pixel, l);
  albedoSum[at] += albedo;
  normalSum[at] += normal;
  if (traversalCut) atomicAdd(counters[COUNTER_FAULTS], 1u);
}
