// SPDX-License-Identifier: MIT
// Materials -> rows, one record per primitive (shaders/gpu_types.h).
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "renderer/energy_table.hpp"
#include "renderer/gpu_shapes.hpp"

namespace steradian {

/// The material on a primitive: the scene's, or a black body that emits as its area light says.
Material materialOf(const Scene& scene, const SurfaceLink& link);
/// FEATURE_* and MATERIAL_* bits of the material on a primitive.
std::uint32_t materialBits(const Material& material, const SurfaceLink& link);
/// Beer-Lambert coefficients inside a solid of it, 1/m.
glm::vec3 absorptionOf(const Material& material);
/// Whether the material needs GlassTables when energy is compensated.
bool isRoughGlass(std::uint32_t materialBits);

/// Where the tables of a scene's rough glass lie among its rows.
class GlassPlaces {
 public:
  GlassPlaces(GlassTables& tables, bool compensated) : tables_(tables), compensated_(compensated) {}
  /// First row for the material, appended to `rows` when it is new; 0 if it needs none.
  std::uint32_t rowOf(const Material& material, std::uint32_t materialBits, std::vector<glm::vec4>& rows);

 private:
  GlassTables& tables_;
  bool compensated_;
  std::map<float, std::uint32_t> rows_;  // by index of refraction
};

/// MATERIAL_ROWS rows; `light` samples the primitive, or is NO_LIGHT; `refs` are rows of texture references,
/// `glassRow` is the first row of rough glass's table.
void pushMaterial(std::vector<glm::vec4>& rows, const Material& material, std::uint32_t bits,
                  std::uint32_t light, const glm::uvec4& refs = glm::uvec4(0), std::uint32_t glassRow = 0);

}  // namespace steradian
