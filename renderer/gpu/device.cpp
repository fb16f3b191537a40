// SPDX-License-Identifier: MIT
// Opens the chosen device with its queues and features.
#include "renderer/gpu/device.hpp"

#include <cassert>
#include <set>

#include "renderer/gpu/commands.hpp"
#include "renderer/gpu/instance.hpp"
#include "renderer/gpu/pass.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::gpu {
namespace {

vk::raii::SurfaceKHR createSurface(const vk::raii::Instance& instance, const SurfaceSource* source) {
  if (!source) return nullptr;
  const auto handle = source->create(static_cast<VkInstance>(*instance));
  if (handle == 0)
    throw Error(ExitCode::noDevice,
                "the window has no Vulkan surface; without a display use: steradian render");
  return {instance, reinterpret_cast<VkSurfaceKHR>(handle)};
}

Candidate pick(const vk::raii::Instance& instance, vk::SurfaceKHR surface, const std::string& wanted) {
  try {
    const std::vector<Candidate> candidates = judgeDevices(instance, surface);
    return candidates[choose(candidates, wanted)];
  } catch (const vk::SystemError& error) {
    throw Error(ExitCode::noDevice, "the Vulkan devices cannot be listed: " +
                                        plainWords(static_cast<vk::Result>(error.code().value())) +
                                        ". Install mesa-vulkan-drivers or your GPU's driver");
  }
}

/// What outlives a lost device, to the end of the process.
struct Abandoned {
  vk::raii::Context loader;
  vk::raii::Instance instance;
  vk::raii::Device device;
};

}  // namespace

Device::Device(const DeviceRequest& request)
    : loader_(openLoader()), instance_(createInstance(loader_, request)) {
  if (wantsValidation(request)) messages_ = std::make_unique<DebugMessages>(instance_);
  surface_ = createSurface(instance_, request.surface);
  Candidate candidate = pick(instance_, *surface_, request.device);
  physical_ = candidate.physical;
  properties_ = physical_.getProperties();
  memory_ = physical_.getMemoryProperties();
  description_ = candidate.description;
  description_.chosen = true;
  checked(*this, "opening the device", [&] { createDevice(candidate.queues); });
  cache_ = checked(*this, "creating the pipeline cache",
                   [&] { return std::make_unique<PipelineCache>(physical_, device_); });
  passLayout_ = std::make_unique<PassLayout>(*this);
}

Device::~Device() {
  // Destroyed, a driver whose work never ends would wait for it here, and no one would read what was wrong.
  // Drivers end in a fault where an instance ends, or is unloaded, before its device.
  if (lost_) new Abandoned{std::move(loader_), std::move(instance_), std::move(device_)};
}

void Device::createDevice(const QueuePlan& plan) {
  std::set<std::uint32_t> families = {plan.compute, plan.graphics};
  if (plan.present) families.insert(*plan.present);
  const float priority = 1.0f;
  std::vector<vk::DeviceQueueCreateInfo> queues;
  for (const std::uint32_t family : families) queues.push_back({{}, family, 1, &priority});
  std::vector<const char*> extensions;
  if (hasSurface()) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  const vk::PhysicalDeviceFeatures features;  // the shaders need no optional feature
  const vk::DeviceCreateInfo info({}, queues, {}, extensions, &features);
  device_ = vk::raii::Device(physical_, info);
  byKind_[int(QueueKind::compute)] = addQueue(plan.compute);
  byKind_[int(QueueKind::graphics)] = addQueue(plan.graphics);
  if (plan.present) byKind_[int(QueueKind::present)] = addQueue(*plan.present);
}

const QueueRef* Device::addQueue(std::uint32_t family) {
  for (const auto& queue : queues_)
    if (queue->family == family) return queue.get();
  const std::uint32_t bits = physical_.getQueueFamilyProperties()[family].timestampValidBits;
  queues_.push_back(std::make_unique<QueueRef>(device_, family, bits));
  return queues_.back().get();
}

const QueueRef& Device::queue(QueueKind kind) const {
  assert(byKind_[int(kind)] && "a headless device has no present queue");
  return *byKind_[int(kind)];
}

double Device::run(QueueKind kind, const Record& record) const {
  return Commands(*this, kind).run(record);
}

void Device::throwIfLost() const {
  if (lost_)
    throw Error(ExitCode::noDevice, description_.name + ": the device was lost; start again to open it anew");
}

int Device::memoryType(std::uint32_t allowedTypes, vk::MemoryPropertyFlags properties) const {
  for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i)
    if ((allowedTypes >> i & 1u) && (memory_.memoryTypes[i].propertyFlags & properties) == properties)
      return int(i);
  return -1;
}

}  // namespace steradian::gpu
