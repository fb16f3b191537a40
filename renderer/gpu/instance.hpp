// SPDX-License-Identifier: MIT
// The Vulkan instance: extensions, validation layer, and what to tell a user whose machine has no Vulkan.
#pragma once
#include <vulkan/vulkan_raii.hpp>

#include "renderer/renderer.hpp"

namespace steradian::gpu {

/// True when the request or STERADIAN_VALIDATION=1 asks for the validation layer.
bool wantsValidation(const DeviceRequest& request);

/// Throws Error(noDevice) when there is no loader. Load this first, destroy it last.
vk::raii::Context openLoader();

/// Throws Error(noDevice) with a package hint when no driver answers or the validation layer is missing.
vk::raii::Instance createInstance(const vk::raii::Context& loader, const DeviceRequest& request);

}  // namespace steradian::gpu
