// SPDX-License-Identifier: MIT
// Triangles for what glTF has no word for: analytic shapes and the bodies of area lights.
#pragma once
#include <cstdint>
#include <optional>
#include <steradian/records.hpp>
#include <vector>

namespace gltf_export {

/// As a MeshRecord holds them: 3 floats per position and normal, 3 indices per triangle.
struct Triangles {
  std::vector<float> positions, normals;
  std::vector<std::uint32_t> indices;
};

/// The surface in the object's own coordinates; nullopt for kinds without one. Curved ones err by at most
/// 0.12 % of their radius, an infinite plane becomes a square of 2 km.
std::optional<Triangles> tessellated(const steradian::sdk::ObjectRecord& object);

}  // namespace gltf_export
