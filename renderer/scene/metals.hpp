// SPDX-License-Identifier: MIT
// Measured metals as materials: reflectance head-on and its dip near grazing, from optical constants.
#pragma once
#include <array>
#include <span>

#include "renderer/scene/material.hpp"

namespace steradian {

/// Optical constants n + ik at 650, 550 and 450 nm, which stand for red, green and blue: the usual shortcut,
/// good to a few hundredths of a spectral integral under daylight.
struct Metal {
  const char* name;
  const char* source;
  std::array<double, 3> n, k;
};

/// By name; the sources in full stand beside the table.
std::span<const Metal> metals();

/// Exact reflectance at a cosine to the normal, per channel.
glm::dvec3 reflectance(const Metal& metal, double cosine);
/// Exact reflectance at 82 degrees (cos = 1/7) over Schlick's there, at most 1.
glm::vec3 edgeTintOf(const Metal& metal);

/// The same material made of this metal: albedo, edge tint, full metallic; all else is kept.
Material madeOf(const Metal& metal, Material material);

}  // namespace steradian
