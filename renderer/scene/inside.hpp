// SPDX-License-Identifier: MIT
// Which solids hold a point: what a camera's rays run through before they have met anything.
#pragma once
#include "renderer/scene/shape.hpp"

namespace steradian {

/// Whether `point` lies inside the shape under `worldFromObject`. A plane holds what is below it; flat shapes
/// hold nothing, and meshes are not asked (they need not be closed). Any thread.
bool holdsInside(const Shape& shape, const glm::dmat4& worldFromObject, const glm::dvec3& point);

}  // namespace steradian
