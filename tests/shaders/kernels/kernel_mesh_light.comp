#version 460
// SPDX-License-Identifier: MIT
// mesh_light.glsl on the first light of a scene.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "mesh_light.glsl"
#include "random.glsl"

// One shared (p, -), and independent numbers -> (wi, distance) (illuminance, pdf, meshLightPdf of wi, triangle of the mesh).
void main() {
  uint at = invocation();
  Layout l = primitiveLayout();
  vec3 p = questions[0].xyz;
  LightRows light = fetchLight(0u);
  float u = sampleIndependent(0x2545f491u, at, 0u);
  float v = sampleIndependent(0x2545f491u, at, 1u);
  LightSample s = sampleMeshLight(light, p, u, v, l);
  uint triangle = triangleAtShare(light, u);
  float asked = meshLightPdf(light, triangle, p, s.wi, l);
  answers[2u * at] = vec4(s.wi, s.distance);
  answers[2u * at + 1u] = vec4(s.illuminance.x, s.pdf, asked, float(floatBitsToUint(fetchMesh(triangle).w)));
}
