// SPDX-License-Identifier: MIT
// The environment -> rows and sampling tables (shaders/gpu_types.h).
#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "renderer/scene/scene.hpp"

namespace steradian {

/// Whether an environment light is worth a ray of its own at each vertex, beside the paths that meet it: an
/// image is, a gradient from a contrast of 3 on. Below, the ray costs more than it saves: on a mesh under a
/// plain sky error^2 x time is 0.75 times as large without it, among analytic shapes 0.93 times; at a
/// contrast of 10 it is 1.13 times (user time of `steradian render --spp 64 --report`).
bool skyIsSampled(const Light& light);
/// ENVIRONMENT_ROWS rows of an environment light under `worldFromObject`; of black without one.
std::vector<glm::vec4> environmentRows(const Light* light, const glm::dmat4& worldFromObject);
/// What follows ENERGY_ROWS in the tables (layout in shaders/environment.glsl): the image's texels, 3
/// channels of finite values >= 0, and their luminance times solid angle as shares for sampling.
std::vector<glm::vec4> environmentTables(const Image& image);

/// Loop iterations that one light sample of any environment takes at most: two searches in tables of up to
/// 65,536 rows, each with its last, failing test.
inline constexpr std::uint64_t environmentIterations = 2 * (16 + 1);

}  // namespace steradian
