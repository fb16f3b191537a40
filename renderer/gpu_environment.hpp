// SPDX-License-Identifier: MIT
// The environment -> rows and sampling tables (shaders/gpu_types.h).
#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "renderer/scene/scene.hpp"

namespace steradian {

/// ENVIRONMENT_ROWS rows of an environment light under `worldFromObject`; of black without one.
std::vector<glm::vec4> environmentRows(const Light* light, const glm::dmat4& worldFromObject);
/// What follows ENERGY_ROWS in the tables (layout in shaders/environment.glsl): the image's texels, 3
/// channels of finite values >= 0, and their luminance times solid angle as shares for sampling.
std::vector<glm::vec4> environmentTables(const Image& image);

/// Loop iterations that one light sample of any environment takes at most: two searches in tables of up to
/// 65,536 rows, each with its last, failing test.
inline constexpr std::uint64_t environmentIterations = 2 * (16 + 1);

}  // namespace steradian
