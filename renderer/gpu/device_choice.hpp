// SPDX-License-Identifier: MIT
// Which physical device and which of its queue families to use.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "renderer/renderer.hpp"

namespace steradian::gpu {

/// Queue families for each kind of work; equal numbers mean one shared queue.
struct QueuePlan {
  std::uint32_t compute = 0;
  std::uint32_t graphics = 0;
  std::optional<std::uint32_t> present;  // absent when headless
};

/// One physical device, judged.
struct Candidate {
  vk::raii::PhysicalDevice physical;
  DeviceDescription description;  // `chosen` is not set here
  QueuePlan queues;               // valid when description.usable
  int rank = 0;                   // discrete 4, integrated 3, virtual 2, CPU 1, other 0
};

/// Chooses families: compute prefers a family without graphics (it runs beside the display), present prefers
/// the graphics family. Absent when a needed kind does not exist; `reason` then says which.
/// `surface` null = headless.
std::optional<QueuePlan> planQueues(const vk::raii::PhysicalDevice& physical, vk::SurfaceKHR surface,
                                    std::string& reason);

/// All devices of the instance in the loader's order, judged. Throws vk::SystemError.
std::vector<Candidate> judgeDevices(const vk::raii::Instance& instance, vk::SurfaceKHR surface);

/// Position in `candidates` of the wanted device: an index, a case-insensitive part of its name, or empty for
/// the best one. Throws Error(noDevice) which lists what there is.
std::size_t choose(const std::vector<Candidate>& candidates, const std::string& wanted);

}  // namespace steradian::gpu
