// SPDX-License-Identifier: MIT
// Creates the instance; every way in which a machine can lack Vulkan ends in one clear line.
#include "renderer/gpu/instance.hpp"

#include <cstdlib>
#include <cstring>

#include "renderer/gpu/check.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::gpu {
namespace {

constexpr const char* validationLayer = "VK_LAYER_KHRONOS_validation";
constexpr const char* driverHint =
    "Install mesa-vulkan-drivers (apt install mesa-vulkan-drivers) or your GPU's driver; if VK_DRIVER_FILES "
    "or "
    "VK_ICD_FILENAMES is set, check the files that it names";

void requireValidationLayer(const vk::raii::Context& loader) {
  for (const vk::LayerProperties& layer : loader.enumerateInstanceLayerProperties())
    if (std::strcmp(layer.layerName, validationLayer) == 0) return;
  throw Error(ExitCode::noDevice,
              "Vulkan validation was asked for, but its layer is not installed. Install "
              "vulkan-validationlayers (apt install vulkan-validationlayers) or unset STERADIAN_VALIDATION");
}

std::string noDriver(vk::Result result) {
  switch (result) {
    case vk::Result::eErrorIncompatibleDriver:
      return "no Vulkan driver was found";
    case vk::Result::eErrorOutOfHostMemory:  // what the loader says of an ICD json that it cannot parse
      return "the Vulkan driver description (ICD json) is broken, or memory is short";
    case vk::Result::eErrorExtensionNotPresent:
      return "the Vulkan driver cannot draw into this kind of window";
    default:
      return "Vulkan could not start: " + plainWords(result);
  }
}

}  // namespace

bool wantsValidation(const DeviceRequest& request) {
  const char* variable = std::getenv("STERADIAN_VALIDATION");
  return request.validation || (variable && std::strcmp(variable, "1") == 0);
}

vk::raii::Context openLoader() {
  try {
    return vk::raii::Context();
  } catch (const std::runtime_error&) {
    throw Error(ExitCode::noDevice, "the Vulkan loader (libvulkan.so.1) was not found. Install libvulkan1");
  }
}

vk::raii::Instance createInstance(const vk::raii::Context& loader, const DeviceRequest& request) {
  std::vector<const char*> extensions, layers;
  if (request.surface) extensions = request.surface->instanceExtensions;
  const auto synchronization = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
  vk::ValidationFeaturesEXT features(synchronization);
  const bool validation = wantsValidation(request);
  if (validation) {
    requireValidationLayer(loader);
    layers.push_back(validationLayer);
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  }
  const vk::ApplicationInfo application("steradian", 1, "steradian", 1, VK_API_VERSION_1_2);
  const vk::InstanceCreateInfo info({}, &application, layers, extensions, validation ? &features : nullptr);
  try {
    return vk::raii::Instance(loader, info);
  } catch (const vk::SystemError& error) {
    const auto result = static_cast<vk::Result>(error.code().value());
    throw Error(ExitCode::noDevice, noDriver(result) + ". " + driverHint);
  }
}

}  // namespace steradian::gpu
