// SPDX-License-Identifier: MIT
// What the vertices of a mesh carry, in the form that shaders/mesh_surface.glsl reads.
#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "renderer/scene/mesh.hpp"

namespace steradian {

/// Rows: one per triangle in the order of the mesh (bits: first rows of its three vertices, counted from
/// here, -), then for each vertex those rows that the flags ask for, in this order:
///   MESH_NORMALS or MESH_TANGENTS  unit normal, bits: tangent (see packTangent)
///   MESH_UV0 or MESH_UV1           u0, v0, u1, v1
///   MESH_COLORS                    linear RGBA
/// A mesh that carries nothing has no rows.
struct VertexRows {
  std::vector<glm::vec4> rows;
  std::uint32_t flags = 0;  // MESH_*
};

/// Linear in the size of the mesh. Without normals those of the facets count, also for tangents.
VertexRows vertexRows(const Mesh& mesh);

/// Octahedral map (Cigolle et al., A Survey of Efficient Representations for Independent Unit Vectors, JCGT
/// 3(2), 2014) with 15 bits per axis, within 1e-4 rad; bit 31: the bitangent's sign is negative. Never a
/// NaN's bits.
std::uint32_t packTangent(const glm::vec4& tangent);

}  // namespace steradian
