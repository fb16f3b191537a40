// SPDX-License-Identifier: MIT
// The device functions that renderer.hpp declares for code that sees no Vulkan.
#include "renderer/gpu/device.hpp"
#include "renderer/gpu/instance.hpp"
#include "renderer/scene/error.hpp"

namespace steradian {
namespace {

void markDefault(std::vector<gpu::Candidate>& candidates) {
  for (const gpu::Candidate& candidate : candidates) {
    if (!candidate.description.usable) continue;
    candidates[gpu::choose(candidates, "")].description.chosen = true;
    return;
  }
}

}  // namespace

std::vector<DeviceDescription> describeDevices() {
  const vk::raii::Context loader = gpu::openLoader();
  const vk::raii::Instance instance = gpu::createInstance(loader, {});
  try {
    std::vector<gpu::Candidate> candidates = gpu::judgeDevices(instance, {});
    markDefault(candidates);
    std::vector<DeviceDescription> descriptions;
    for (const gpu::Candidate& candidate : candidates) descriptions.push_back(candidate.description);
    return descriptions;
  } catch (const vk::SystemError& error) {
    throw Error(ExitCode::noDevice, "the Vulkan devices cannot be listed: " +
                                        gpu::plainWords(static_cast<vk::Result>(error.code().value())) +
                                        ". Install mesa-vulkan-drivers or your GPU's driver");
  }
}

std::shared_ptr<gpu::Device> openDevice(const DeviceRequest& request) {
  return std::make_shared<gpu::Device>(request);
}

DeviceDescription describe(const gpu::Device& device) {
  return device.description();
}

int validationMessages(const gpu::Device& device) {
  return device.validationMessages();
}

}  // namespace steradian
