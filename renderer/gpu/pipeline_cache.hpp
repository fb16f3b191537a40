// SPDX-License-Identifier: MIT
// The driver's compiled pipelines, kept on disk between runs.
#pragma once
#include <filesystem>
#include <optional>
#include <vulkan/vulkan_raii.hpp>

namespace steradian::gpu {

/// Loaded at construction, written atomically at destruction. A damaged or foreign file is ignored.
class PipelineCache {
 public:
  /// Lives in $XDG_CACHE_HOME/steradian or ~/.cache/steradian; memory only when neither is set.
  PipelineCache(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device);
  ~PipelineCache();
  PipelineCache(const PipelineCache&) = delete;
  PipelineCache& operator=(const PipelineCache&) = delete;

  const vk::raii::PipelineCache& handle() const { return cache_; }
  /// Writes now what the driver has compiled so far; failures are silent, for a cache is only speed.
  void save() const noexcept;
  /// The file of this device and driver, or absent when there is no cache folder.
  static std::optional<std::filesystem::path> file(const vk::PhysicalDeviceProperties& properties);

 private:
  std::optional<std::filesystem::path> file_;
  std::size_t loadedBytes_ = 0;
  vk::raii::PipelineCache cache_;
};

}  // namespace steradian::gpu
