// SPDX-License-Identifier: MIT
// Result codes in words.
#include "renderer/gpu/check.hpp"

#include "renderer/gpu/device.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::gpu {

std::string plainWords(vk::Result result) {
  switch (result) {
    case vk::Result::eErrorDeviceLost:
      return "the device was lost (driver reset, or a dispatch that never ended)";
    case vk::Result::eErrorOutOfDeviceMemory:
      return "the device has not enough memory";
    case vk::Result::eErrorOutOfHostMemory:
      return "this computer has not enough memory";
    case vk::Result::eErrorSurfaceLostKHR:
      return "the window's surface was lost (did the display server stop?)";
    case vk::Result::eErrorInitializationFailed:
      return "the driver could not start";
    case vk::Result::eErrorTooManyObjects:
      return "the device cannot take more objects of this kind";
    default:
      return "the driver reports " + vk::to_string(result);
  }
}

void raise(const Device& device, const std::string& doing, const vk::SystemError& error) {
  const auto result = static_cast<vk::Result>(error.code().value());
  if (result == vk::Result::eErrorDeviceLost) device.markLost();
  throw Error(ExitCode::noDevice,
              device.description().name + ": " + doing + " failed: " + plainWords(result));
}

}  // namespace steradian::gpu
