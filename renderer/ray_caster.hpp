// SPDX-License-Identifier: MIT
// Single rays against a scene on the device, by the tracer's own traversal: for measurements and tests.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "renderer/gpu_scene.hpp"

namespace steradian {

/// Relative to the camera, that is to GpuScene::origin.
struct CastRay {
  glm::vec3 o;
  float tMax = 1e30f;
  glm::vec3 d;  // unit
  float unused = 0.0f;
};

struct CastHit {
  float t = 0.0f;
  std::uint32_t primitive = gpu::NO_PRIMITIVE;  // in upload order; of a shadow ray only whether there is one
  std::uint32_t triangleRow = 0;                // in the mesh buffer
  float unused = 0.0f;
};

class RayCaster {
 public:
  /// `whileWhile`: form of the loop over a mesh (shaders/bvh.glsl). Textures stay behind: opacity is that of
  /// the material alone. Throws Error(noDevice).
  RayCaster(std::shared_ptr<gpu::Device> device, GpuScene scene, bool whileWhile = true);
  ~RayCaster();

  struct Answer {
    std::vector<CastHit> hits;
    double milliseconds = 0.0;  // device time of the fastest run
  };
  /// `any`: shadow rays, from which anything before tMax counts. Blocks. At most 4 million rays.
  Answer cast(std::span<const CastRay> rays, bool any, int runs = 1);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace steradian
