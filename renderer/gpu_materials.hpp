// SPDX-License-Identifier: MIT
// Materials -> rows, one record per primitive (shaders/gpu_types.h).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/gpu_shapes.hpp"

namespace steradian {

/// The material on a primitive: the scene's, or a black body that emits as its area light says.
Material materialOf(const Scene& scene, const SurfaceLink& link);
/// FEATURE_* and MATERIAL_* bits of the material on a primitive.
std::uint32_t materialBits(const Material& material, const SurfaceLink& link);
/// MATERIAL_ROWS rows; `light` samples the primitive, or is NO_LIGHT; `refs` are rows of texture references.
void pushMaterial(std::vector<glm::vec4>& rows, const Material& material, std::uint32_t bits,
                  std::uint32_t light, const glm::uvec4& refs = glm::uvec4(0));

}  // namespace steradian
