// SPDX-License-Identifier: MIT
// Primitives as triangle meshes: attributes, morph targets and skins at one time.
#pragma once
#include "animation.hpp"

namespace gltf {

struct Triangles {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> tangents, colors;
  std::vector<glm::vec2> uv0, uv1;
  std::vector<std::uint32_t> indices;
  std::vector<std::string> notes;  // for the report: what was approximated
};

/// What bends a primitive away from its rest.
struct Bend {
  std::vector<double> weights;     // of the morph targets
  std::vector<glm::dmat4> joints;  // world from bind space; empty = no skin
};

/// Throws BadInput with the place of what is wrong: such a primitive is left out as a whole.
Triangles readPrimitive(const Document& document, const tinygltf::Primitive& primitive,
                        const std::string& place, const Bend& bend);

/// The matrices of a skin in a pose. Throws BadInput.
std::vector<glm::dmat4> jointsOf(const Document& document, std::size_t skin, const Pose& pose);

// Parts of readPrimitive: triangles.cpp and bend.cpp.
std::vector<std::uint32_t> readTriangles(const Document& document, const tinygltf::Primitive& primitive,
                                         std::size_t vertices, std::vector<std::string>& notes);
void morph(const Document& document, const tinygltf::Primitive& primitive, const std::string& place,
           const std::vector<double>& weights, Triangles& out);
void skin(const Document& document, const tinygltf::Primitive& primitive,
          const std::vector<glm::dmat4>& joints, Triangles& out);

}  // namespace gltf
