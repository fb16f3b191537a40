// SPDX-License-Identifier: MIT
// A light's strength in the units that lamps are sold by.
#pragma once
#include <optional>

#include <glm/glm.hpp>

#include "renderer/scene/light.hpp"

namespace steradian {

/// cd/m^2 per unit of linear Rec. 709.
double luminanceOf(const glm::vec3& linear);

/// Luminous flux in lumen: all the light that the source sends out, its colour's luminance included. nullopt
/// where it has no meaning (directional light, sky) or no closed form (a sphere that is scaled unevenly).
std::optional<double> luminousFlux(const Light& light, const glm::dmat4& worldFromObject);

/// Luminous intensity in candela straight ahead, far from the source; nullopt as above.
std::optional<double> intensityAhead(const Light& light, const glm::dmat4& worldFromObject);

}  // namespace steradian
