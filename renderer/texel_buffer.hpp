// SPDX-License-Identifier: MIT
// The textures of a scene on the device.
#pragma once
#include "renderer/gpu/buffer.hpp"
#include "renderer/gpu_scene.hpp"

namespace steradian {

/// An empty buffer for a scene without textures. Throws Error(noDevice) naming what they need and what the
/// device allows.
gpu::Buffer texelBuffer(const gpu::Device& device, const GpuScene& scene);

}  // namespace steradian
