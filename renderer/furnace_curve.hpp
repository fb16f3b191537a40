// SPDX-License-Identifier: MIT
// How much light a material gives back at every roughness: the white-furnace view of the material editor.
#pragma once
#include <vector>

#include "renderer/scene/material.hpp"

namespace steradian {

/// Mean albedo per channel (over directions, weighted by the cosine) of an opaque material at `points` >= 2
/// roughnesses evenly from 0 to 1; its own roughness is not used. What glass transmits counts as given back,
/// the edge tint as Schlick. `compensated` as RenderSettings::energyCompensation. By quadrature, about a
/// millisecond for 32 points. Any thread.
std::vector<glm::vec3> furnaceCurve(const Material& material, int points, bool compensated = true);

}  // namespace steradian
