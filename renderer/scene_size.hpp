// SPDX-License-Identifier: MIT
// What a scene takes on the device, and whether the device can hold it.
#pragma once
#include <cstdint>
#include <string>

#include "renderer/gpu_scene.hpp"

namespace steradian {

namespace gpu {
class Device;
}

/// One line that names what is too large, its largest part, the limit and a remedy; empty when a device whose
/// texel buffers hold `mostElements` rows or words takes the scene. `packed`: of `scene`.
std::string tooLarge(const Scene& scene, const GpuScene& packed, std::uint64_t mostElements);
/// Throws Error(badInput) with that line.
void checkSize(const gpu::Device& device, const Scene& scene, const GpuScene& packed);

}  // namespace steradian
