// SPDX-License-Identifier: MIT
// What a film counts radiance in.
#pragma once
#include "renderer/gpu_scene.hpp"

namespace steradian {

/// Radiance of the brightest thing that a ray can meet, nit. `brightestTexel` of the environment's image.
float brightestEmission(const GpuScene& scene, float brightestTexel);

/// A power of two: 2^12 of what the exposure shows as white, so that a film, which reaches from 2^30 down to
/// 2^-60 of its unit, counts in 2^-48 of white; more where a million samples of the brightest emission would
/// not fit otherwise. A function of the scene and its settings alone: parts of one picture share it.
float filmUnit(float brightestEmission, const DisplaySettings& display);

}  // namespace steradian
