// SPDX-License-Identifier: MIT
// What the vertices of a mesh carry (renderer/mesh/vertex_rows.hpp), at the corners of one triangle.
#ifndef MESH_ATTRIBUTES_GLSL
#define MESH_ATTRIBUTES_GLSL
#include "scene.glsl"

// Where the vertices of a triangle lie in the mesh buffer.
struct Corners {
  uint flags;  // MESH_*
  uint a;      // first rows
  uint b;
  uint c;
};

// `triangle`: its row among those of the hierarchy. Of a mesh that carries nothing, a row that may be fetched.
Corners cornersOf(uint primitive, uint triangle, Layout l) {
  vec4 mesh = fetchRow(instanceRow(l, primitive) + 3u);
  uint first = floatBitsToUint(mesh.z);
  uint flags = floatBitsToUint(mesh.w);
  bool some = flags != 0u;
  vec4 rows = fetchMesh(some ? first + floatBitsToUint(fetchMesh(triangle).w) : triangle);
  return Corners(flags, some ? first + floatBitsToUint(rows.x) : triangle, some ? first + floatBitsToUint(rows.y) : triangle,
                 some ? first + floatBitsToUint(rows.z) : triangle);
}

uint uvOffset(uint flags) { return (flags & (MESH_NORMALS | MESH_TANGENTS)) != 0u ? 1u : 0u; }
uint colorOffset(uint flags) { return uvOffset(flags) + ((flags & (MESH_UV0 | MESH_UV1)) != 0u ? 1u : 0u); }

// The same row of all three corners, weighed. A row that is not there gives anything.
vec4 interpolatedRow(Corners corners, uint offset, vec3 weights) {
  return fetchMesh(corners.a + offset) * weights.x + fetchMesh(corners.b + offset) * weights.y +
         fetchMesh(corners.c + offset) * weights.z;
}

// (u0, v0, u1, v1); 0 where there are none.
vec4 interpolatedUv(Corners corners, vec3 weights) {
  bool some = (corners.flags & (MESH_UV0 | MESH_UV1)) != 0u;
  vec4 uv = interpolatedRow(corners, some ? uvOffset(corners.flags) : 0u, weights);
  return some ? uv : vec4(0.0);
}

vec4 interpolatedColor(Corners corners, vec3 weights) {
  bool some = (corners.flags & MESH_COLORS) != 0u;
  vec4 color = interpolatedRow(corners, some ? colorOffset(corners.flags) : 0u, weights);
  return some ? color : vec4(1.0);
}

#endif
