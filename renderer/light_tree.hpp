// SPDX-License-Identifier: MIT
// The tree by which shaders choose one of many lights (shaders/light_tree.glsl).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace steradian {

/// Rows of the tree over lights given as their own rows (shaders/gpu_types.h); none for no lights. Clusters
/// are split where power times squared size becomes least (after Conty Estevez & Kulla 2018, section 4.3).
std::vector<glm::vec4> lightTreeRows(std::span<const glm::vec4> lights);

/// Steps from the root to any leaf are at most this many.
std::uint32_t lightTreeDepth(std::uint32_t lightCount);

}  // namespace steradian
