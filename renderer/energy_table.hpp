// SPDX-License-Identifier: MIT
// Directional albedo of white GGX facets, tabulated once per process (layout in shaders/gpu_types.h).
#pragma once
#include <vector>

#include <glm/glm.hpp>

namespace steradian {

/// ENERGY_ROWS rows. Any thread.
const std::vector<glm::vec4>& energyTable();

}  // namespace steradian
