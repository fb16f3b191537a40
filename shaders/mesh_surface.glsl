// SPDX-License-Identifier: MIT
// What shading needs of a point of a mesh: the smooth normal, the directions of the texture coordinates, colour.
#ifndef MESH_SURFACE_GLSL
#define MESH_SURFACE_GLSL
#include "mesh_attributes.glsl"
#include "surface.glsl"

struct MeshPoint {
  vec3 normal;      // for shading: unit, on the outer side
  vec3 tangent;     // unit, along +u
  vec3 bitangent;   // unit, the way that y of normal maps counts
  vec4 uv;          // sets 0 and 1
  vec2 uvPerMetre;  // how fast either runs
  vec4 color;
};

// Octahedral map of 15 bits per axis (renderer/mesh/vertex_rows.hpp).
vec3 unpackedTangent(uint bits) {
  float x = float(int((bits >> 15) & 32767u)) * (2.0 / 32767.0) - 1.0;
  float y = float(int(bits & 32767u)) * (2.0 / 32767.0) - 1.0;
  float z = 1.0 - abs(x) - abs(y);
  float fold = max(-z, 0.0);
  return vec3(x + (x >= 0.0 ? -fold : fold), y + (y >= 0.0 ? -fold : fold), z);
}

// `fallback` where v has no length.
vec3 unitOr(vec3 v, vec3 fallback) {
  float length2 = dot(v, v);
  return length2 > 1e-30 ? v * inversesqrt(length2) : fallback;
}

// A normal is never taken to lie behind its facet: one that does is mirrored in the facet's plane.
vec3 onOuterSide(vec3 normal, vec3 facet) {
  float c = dot(normal, facet);
  return c < 0.0 ? normal - facet * (2.0 * c) : normal;
}

// How texture coordinates run over the triangle with the edges e1 and e2.
struct UvRun {
  vec3 tangent;  // not normalized; 0 where they do not run at all
  float side;    // of the bitangent
  float perMetre;
};

// (u1, v1), (u2, v2): what they change by along the edges. v counts downward, y of a normal map upward.
UvRun uvRun(vec3 e1, vec3 e2, vec3 normal, float u1, float v1, float u2, float v2) {
  float area = u1 * v2 - u2 * v1;
  float turn = area < 0.0 ? -1.0 : 1.0;
  vec3 tangent = (e1 * v2 - e2 * v1) * turn;
  vec3 up = (e1 * u2 - e2 * u1) * turn;
  vec3 facet = cross(e1, e2);
  float side = dot(cross(normal, tangent), up) < 0.0 ? -1.0 : 1.0;
  return UvRun(area == 0.0 ? vec3(0.0) : tangent, side, sqrt(abs(area) * inversesqrt(max(dot(facet, facet), 1e-37))));
}

// Rows of an instance that turn directions of the mesh into the world's.
struct MeshAxes {
  vec4 x;
  vec4 y;
  vec4 z;
};

vec3 smoothNormal(Surface surface, uint instance, vec3 n) {
  vec3 normal = fetchRow(instance).xyz * n.x + fetchRow(instance + 1u).xyz * n.y + fetchRow(instance + 2u).xyz * n.z;
  return onOuterSide(unitOr(normal, surface.normal), surface.normal);
}

// Tangents as the vertices have them, or as the texture coordinates run.
void addTangents(inout MeshPoint point, UvRun run, MeshAxes axes, bool given, vec3 weights, vec3 packed) {
  vec3 along = run.tangent;
  float side = run.side;
  if (given) {
    uint first = floatBitsToUint(packed.x);
    vec3 t = unpackedTangent(first) * weights.x + unpackedTangent(floatBitsToUint(packed.y)) * weights.y +
             unpackedTangent(floatBitsToUint(packed.z)) * weights.z;
    along = timesRows(axes.x, axes.y, axes.z, t);
    float mirrored = dot(axes.x.xyz, cross(axes.y.xyz, axes.z.xyz)) < 0.0 ? -1.0 : 1.0;
    side = (first >> 31) != 0u ? -mirrored : mirrored;
  }
  point.tangent = unitOr(along - point.normal * dot(point.normal, along), frameAround(point.normal).t);
  point.bitangent = cross(point.normal, point.tangent) * side;
}

// `second`: which texture coordinates tangents follow where the mesh has none.
MeshPoint meshPoint(Surface surface, Hit hit, bool second, Layout l) {
  uint row = instanceRow(l, hit.primitive);
  Corners corners = cornersOf(hit.primitive, hit.triangle, l);
  MeshPoint point = MeshPoint(surface.normal, vec3(0.0), vec3(0.0), vec4(0.0), vec2(0.0), vec4(1.0));
  vec4 a = fetchMesh(corners.a);
  vec4 b = fetchMesh(corners.b);
  vec4 c = fetchMesh(corners.c);
  vec3 w = surface.weights;
  bool hasNormals = (corners.flags & MESH_NORMALS) != 0u;
  if (hasNormals) point.normal = smoothNormal(surface, row, a.xyz * w.x + b.xyz * w.y + c.xyz * w.z);
  if (kTextures) {
    MeshAxes axes = MeshAxes(fetchRow(row + 4u), fetchRow(row + 5u), fetchRow(row + 6u));
    vec3 v0 = fetchMesh(hit.triangle).xyz;
    vec3 e1 = timesRows(axes.x, axes.y, axes.z, fetchMesh(hit.triangle + 1u).xyz - v0);
    vec3 e2 = timesRows(axes.x, axes.y, axes.z, fetchMesh(hit.triangle + 2u).xyz - v0);
    bool hasUv = (corners.flags & (MESH_UV0 | MESH_UV1)) != 0u;
    uint offset = hasUv ? uvOffset(corners.flags) : 0u;
    vec4 uv0 = fetchMesh(corners.a + offset);
    vec4 uv1 = fetchMesh(corners.b + offset) - uv0;
    vec4 uv2 = fetchMesh(corners.c + offset) - uv0;
    point.uv = hasUv ? uv0 + uv1 * w.y + uv2 * w.z : vec4(0.0);
    UvRun first = uvRun(e1, e2, point.normal, uv1.x, uv1.y, uv2.x, uv2.y);
    UvRun other = uvRun(e1, e2, point.normal, uv1.z, uv1.w, uv2.z, uv2.w);
    point.uvPerMetre = vec2(first.perMetre, other.perMetre);
    UvRun run = first;
    if (second) run = other;
    addTangents(point, run, axes, (corners.flags & MESH_TANGENTS) != 0u, w, vec3(a.w, b.w, c.w));
    point.color = interpolatedColor(corners, w);
  }
  return point;
}

#endif
