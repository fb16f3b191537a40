// SPDX-License-Identifier: MIT
// Meshes that glow, as lights: a triangle in proportion to its share of the mesh's area, then a
// direction that is uniform in its solid angle.
#ifndef MESH_LIGHT_GLSL
#define MESH_LIGHT_GLSL
#include "lights.glsl"
#include "mesh_attributes.glsl"
#include "surface.glsl"
#include "texture.glsl"
#include "triangle_sampling.glsl"

bool isMeshLight(LightRows light) { return kMeshLights && uint(light.a.w) == LIGHT_MESH; }

struct LightTriangle {
  vec3 corner;
  vec3 edge1;
  vec3 edge2;
  float before;  // the share of the mesh's area that lies before this triangle,
  float share;   // and its own
};

LightTriangle lightTriangle(LightRows light, uint triangle, Layout l) {
  uint row = instanceRow(l, floatBitsToUint(light.d.w));
  vec3 centre = vec3(fetchRow(row).w, fetchRow(row + 1u).w, fetchRow(row + 2u).w);
  vec4 x = fetchRow(row + 4u);
  vec4 y = fetchRow(row + 5u);
  vec4 z = fetchRow(row + 6u);
  vec4 v0 = fetchMesh(triangle);
  vec4 v1 = fetchMesh(triangle + 1u);
  vec4 v2 = fetchMesh(triangle + 2u);
  return LightTriangle(centre + timesRows(x, y, z, v0.xyz), timesRows(x, y, z, v1.xyz - v0.xyz),
                       timesRows(x, y, z, v2.xyz - v0.xyz), v1.w, v2.w - v1.w);
}

// Row of the triangle in whose share u lies.
uint triangleAtShare(LightRows light, float u) {
  uint first = floatBitsToUint(light.d.x);
  uint low = 0u;
  uint high = floatBitsToUint(light.d.y) - 1u;
  while (low < high) {
    uint middle = low + ((high - low) >> 1);
    bool beyond = fetchMesh(first + middle * BVH_TRIANGLE_ROWS + 2u).w <= u;
    low = beyond ? middle + 1u : low;
    high = beyond ? high : middle;
  }
  return first + low * BVH_TRIANGLE_ROWS;
}

// Factor of the radiance that the emission texture gives, in full resolution, since samples average it, and of it the
// share that is there where the mesh has holes.
vec3 emissionTexture(LightRows light, uint triangle, vec3 weights, Layout l) {
  uint primitive = floatBitsToUint(light.d.w);
  uint ref = floatBitsToUint(fetchRow(params.materialRow + primitive * MATERIAL_ROWS + 6u).w);
  vec3 factor = vec3(kAlpha ? presenceAt(primitive, triangle, weights, l) : 1.0);
  if (kTextures && ref != 0u) {
    TextureRef t = fetchTextureRef(ref);
    vec4 uv = interpolatedUv(cornersOf(primitive, triangle, l), weights);
    bool second = (t.bits & TEXEL_UV1) != 0u;
    factor *= lookUp(t, second ? uv.z : uv.x, second ? uv.w : uv.y, 0u).xyz;
  }
  return factor;
}

LightSample sampleMeshLight(LightRows light, vec3 p, float u, float v, Layout l) {
  uint triangle = triangleAtShare(light, u);
  LightTriangle t = lightTriangle(light, triangle, l);
  TriangleSample s = sampleTriangle(triangleView(t.corner - p, t.edge1, t.edge2), (u - t.before) / max(t.share, 1e-20), v);
  float t2 = max(dot(s.toPoint, s.toPoint), 1e-36);
  float inv = inversesqrt(t2);
  float pdf = s.pdf * t.share;
  vec3 illuminance = pdf > 0.0 ? light.b.xyz * emissionTexture(light, triangle, s.weights, l) / pdf : vec3(0.0);
  // The mesh may shadow itself, so the ray ends just before the point, by more than rounding does.
  return LightSample(s.toPoint * inv, t2 * inv * 0.99998, illuminance, pdf, NO_PRIMITIVE, vec3(0.0));
}

// Density with which sampleMeshLight() would have chosen wi, for a direction from p that meets this triangle (its row).
float meshLightPdf(LightRows light, uint triangle, vec3 p, vec3 wi, Layout l) {
  LightTriangle t = lightTriangle(light, triangle, l);
  return trianglePdf(triangleView(t.corner - p, t.edge1, t.edge2), wi) * t.share;
}

#endif
