// SPDX-License-Identifier: MIT
// The meshes of a scene on the device.
#pragma once
#include "renderer/gpu/buffer.hpp"
#include "renderer/gpu_scene.hpp"

namespace steradian {

/// An empty buffer for a scene without meshes. Throws Error(noDevice) naming what they need and what the
/// device allows.
gpu::Buffer meshBuffer(const gpu::Device& device, const GpuScene& scene);

}  // namespace steradian
