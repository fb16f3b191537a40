// SPDX-License-Identifier: MIT
// Scene -> the rows and counts that shaders read (shaders/gpu_types.h): camera-relative, double until the
// last step.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "renderer/renderer.hpp"
#include "shaders/gpu_types.h"

namespace steradian {

/// Equal values give equal radiance: the film starts over exactly when two of them differ.
struct GpuScene {
  std::vector<glm::vec4> rows;
  gpu::TraceParams params{};   // counts, table rows and settings; rows and samples of a dispatch left 0
  std::uint32_t features = 0;  // FEATURE_* bits that this scene needs
  glm::dvec3 origin{0.0};      // world position of the rows' origin (the camera)
  std::shared_ptr<const Image> environment;  // whose tables the shaders read; null = none

  bool sameRadiance(const GpuScene& other) const;
};

/// Invisible objects and shapes without extent are left out.
GpuScene packScene(const Scene& scene, const CameraView& view, Extent film);

}  // namespace steradian
