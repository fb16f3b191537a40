// SPDX-License-Identifier: MIT
// Judges the devices of a machine and picks one.
#include "renderer/gpu/device_choice.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>

#include "renderer/gpu/pass.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::gpu {
namespace {

int rankOf(vk::PhysicalDeviceType type) {
  switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
      return 4;
    case vk::PhysicalDeviceType::eIntegratedGpu:
      return 3;
    case vk::PhysicalDeviceType::eVirtualGpu:
      return 2;
    case vk::PhysicalDeviceType::eCpu:
      return 1;
    default:
      return 0;
  }
}

const char* nameOf(vk::PhysicalDeviceType type) {
  switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
      return "discrete GPU";
    case vk::PhysicalDeviceType::eIntegratedGpu:
      return "integrated GPU";
    case vk::PhysicalDeviceType::eVirtualGpu:
      return "virtual GPU";
    case vk::PhysicalDeviceType::eCpu:
      return "CPU";
    default:
      return "other";
  }
}

std::string versionText(std::uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) +
         "." + std::to_string(VK_API_VERSION_PATCH(version));
}

std::string queuesText(const QueuePlan& plan) {
  std::string text =
      "compute family " + std::to_string(plan.compute) + ", graphics family " + std::to_string(plan.graphics);
  if (plan.present) text += ", present family " + std::to_string(*plan.present);
  return text;
}

bool hasSwapchain(const vk::raii::PhysicalDevice& physical) {
  for (const vk::ExtensionProperties& extension : physical.enumerateDeviceExtensionProperties())
    if (std::strcmp(extension.extensionName, VK_KHR_SWAPCHAIN_EXTENSION_NAME) == 0) return true;
  return false;
}

// What is missing, or empty.
std::string lacks(const vk::raii::PhysicalDevice& physical, const vk::PhysicalDeviceProperties& properties,
                  vk::SurfaceKHR surface) {
  if (properties.apiVersion < VK_API_VERSION_1_2)
    return "supports only Vulkan " + versionText(properties.apiVersion) + ", 1.2 is needed";
  if (properties.limits.maxPerStageDescriptorStorageBuffers < storageBindings)
    return "allows only " + std::to_string(properties.limits.maxPerStageDescriptorStorageBuffers) +
           " storage buffers per shader, " + std::to_string(storageBindings) + " are needed";
  if (surface && !hasSwapchain(physical)) return "cannot draw into windows (no VK_KHR_swapchain)";
  return {};
}

std::optional<std::uint32_t> presentFamily(const vk::raii::PhysicalDevice& physical, vk::SurfaceKHR surface,
                                           std::uint32_t preferred, std::size_t families) {
  if (physical.getSurfaceSupportKHR(preferred, surface)) return preferred;
  for (std::uint32_t family = 0; family < families; ++family)
    if (physical.getSurfaceSupportKHR(family, surface)) return family;
  return std::nullopt;
}

Candidate judge(const vk::raii::PhysicalDevice& physical, int index, vk::SurfaceKHR surface) {
  const auto chain =
      physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
  const auto& properties = chain.get<vk::PhysicalDeviceProperties2>().properties;
  const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
  DeviceDescription description;
  description.index = index;
  description.name = properties.deviceName.data();
  description.type = nameOf(properties.deviceType);
  description.api = versionText(properties.apiVersion);
  description.reason = lacks(physical, properties, surface);
  if (description.reason.empty())
    description.driver = std::string(driver.driverName.data()) + " " + driver.driverInfo.data();
  std::optional<QueuePlan> plan;
  if (description.reason.empty()) plan = planQueues(physical, surface, description.reason);
  description.usable = plan.has_value();
  if (plan) description.queues = queuesText(*plan);
  return {physical, description, plan.value_or(QueuePlan()), rankOf(properties.deviceType)};
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string listing(const std::vector<Candidate>& candidates) {
  std::string text;
  for (const Candidate& candidate : candidates) {
    const DeviceDescription& d = candidate.description;
    text += (text.empty() ? "" : "; ") + std::to_string(d.index) + " " + d.name;
    if (!d.usable) text += " (not usable: " + d.reason + ")";
  }
  return text;
}

bool answersTo(const DeviceDescription& description, const std::string& wanted) {
  int index = -1;
  const char* end = wanted.data() + wanted.size();
  const auto parsed = std::from_chars(wanted.data(), end, index);
  if (parsed.ec == std::errc() && parsed.ptr == end) return description.index == index;
  return lowerCase(description.name).find(lowerCase(wanted)) != std::string::npos;
}

}  // namespace

std::optional<QueuePlan> planQueues(const vk::raii::PhysicalDevice& physical, vk::SurfaceKHR surface,
                                    std::string& reason) {
  const std::vector<vk::QueueFamilyProperties> families = physical.getQueueFamilyProperties();
  const auto has = [&](std::size_t i, vk::QueueFlagBits kind) { return bool(families[i].queueFlags & kind); };
  std::optional<std::uint32_t> graphics, compute, dedicated;
  for (std::uint32_t i = 0; i < families.size(); ++i) {
    const bool draws = has(i, vk::QueueFlagBits::eGraphics), computes = has(i, vk::QueueFlagBits::eCompute);
    if (draws && (!graphics || (computes && !has(*graphics, vk::QueueFlagBits::eCompute)))) graphics = i;
    if (computes && !draws && !dedicated) dedicated = i;
    if (computes && !compute) compute = i;
  }
  if (!graphics) reason = "has no graphics queue";
  if (!compute) reason = "has no compute queue";
  if (!graphics || !compute) return std::nullopt;
  QueuePlan plan;
  plan.graphics = *graphics;
  plan.compute = dedicated ? *dedicated : has(*graphics, vk::QueueFlagBits::eCompute) ? *graphics : *compute;
  if (!surface) return plan;
  plan.present = presentFamily(physical, surface, plan.graphics, families.size());
  if (plan.present) return plan;
  reason = "cannot present to this window";
  return std::nullopt;
}

std::vector<Candidate> judgeDevices(const vk::raii::Instance& instance, vk::SurfaceKHR surface) {
  std::vector<Candidate> candidates;
  for (const vk::raii::PhysicalDevice& physical : instance.enumeratePhysicalDevices())
    candidates.push_back(judge(physical, int(candidates.size()), surface));
  return candidates;
}

std::size_t choose(const std::vector<Candidate>& candidates, const std::string& wanted) {
  std::optional<std::size_t> best;
  bool named = false;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& candidate = candidates[i];
    if (!wanted.empty() && !answersTo(candidate.description, wanted)) continue;
    named = true;
    if (candidate.description.usable && (!best || candidate.rank > candidates[*best].rank)) best = i;
  }
  if (best) return *best;
  const std::string what = wanted.empty() ? "no usable Vulkan device"
                           : named        ? "the Vulkan device \"" + wanted + "\" cannot be used"
                                          : "no Vulkan device is called \"" + wanted + "\"";
  throw Error(ExitCode::noDevice, what + "; this machine has: " + listing(candidates));
}

}  // namespace steradian::gpu
