// SPDX-License-Identifier: MIT
// Triangle meshes: heavy data behind a shared pointer, never copied, compared by identity.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace steradian {

/// Attributes are one per vertex or absent (empty). Counter-clockwise triangles face outward.
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;   // metres, finite
  std::vector<glm::uvec3> triangles;  // indices into positions
  std::vector<glm::vec3> normals;     // unit; absent = flat facets
  std::vector<glm::vec4> tangents;    // unit xyz along +u, w = sign of the bitangent cross(normal, tangent)
  std::vector<glm::vec2> uv0, uv1;    // (0, 0) = top left of a texture, as glTF
  std::vector<glm::vec4> colors;      // linear RGBA in [0, 1], multiplies albedo and opacity
  glm::vec3 boxMin{0.0f}, boxMax{0.0f};  // of the positions: sharedMesh fills them
};

/// An object's mesh; several objects may share one.
struct MeshShape {
  std::shared_ptr<const Mesh> mesh;                   // not null
  bool operator==(const MeshShape&) const = default;  // by identity
};

/// What is wrong with a mesh, one line, or empty: counts, indices, finite values. Linear in its size.
std::string problemOf(const Mesh& mesh);

/// The way every mesh comes into a scene: with its box.
std::shared_ptr<const Mesh> sharedMesh(Mesh mesh);

}  // namespace steradian
