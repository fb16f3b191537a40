// SPDX-License-Identifier: MIT
// The box around objects.
#pragma once
#include <optional>
#include <set>

#include <glm/glm.hpp>

#include "renderer/scene/scene.hpp"

namespace steradian {

/// An axis-aligned box in the world, metres.
struct Bounds {
  glm::dvec3 min{0.0}, max{0.0};
  glm::dvec3 center() const { return 0.5 * (min + max); }
  double radius() const { return 0.5 * glm::length(max - min); }
};

/// Of the visible, finite parts of the objects (all when `objects` is null); nullopt when there is none.
/// Lights without a size and cameras count as points; a sky is everywhere.
std::optional<Bounds> boundsOf(const Scene& scene, const std::set<Id>* objects = nullptr);

}  // namespace steradian
