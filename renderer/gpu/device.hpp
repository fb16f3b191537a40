// SPDX-License-Identifier: MIT
// The opened device: queues, limits, pipeline cache, and the state "lost". Made by steradian::openDevice().
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "renderer/gpu/check.hpp"
#include "renderer/gpu/debug_messages.hpp"
#include "renderer/gpu/device_choice.hpp"
#include "renderer/gpu/pipeline_cache.hpp"
#include "renderer/renderer.hpp"

namespace steradian::gpu {

class PassLayout;

enum class QueueKind { compute, graphics, present };

/// A queue of the device; kinds of one family share one QueueRef.
struct QueueRef {
  vk::raii::Queue handle;
  std::uint32_t family;
  std::uint32_t timestampBits;  // 0 = this family has no timestamps
  mutable std::mutex mutex;     // hold it for vkQueueSubmit, vkQueuePresentKHR, vkQueueWaitIdle

  QueueRef(const vk::raii::Device& device, std::uint32_t family, std::uint32_t timestampBits)
      : handle(device, family, 0), family(family), timestampBits(timestampBits) {}
};

/// Writes commands into a buffer that is being recorded.
using Record = std::function<void(const vk::raii::CommandBuffer&)>;

/// Thread-safe, except destruction. Everything made from a Device must die before it.
class Device {
 public:
  explicit Device(const DeviceRequest& request);  // use openDevice()
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const vk::raii::Instance& instance() const { return instance_; }
  const vk::raii::PhysicalDevice& physical() const { return physical_; }
  const vk::raii::Device& handle() const { return device_; }
  const vk::PhysicalDeviceLimits& limits() const { return properties_.limits; }
  const DeviceDescription& description() const { return description_; }
  int validationMessages() const { return messages_ ? messages_->count() : 0; }

  const QueueRef& queue(QueueKind kind) const;
  const QueueRef& compute() const { return queue(QueueKind::compute); }
  const QueueRef& graphics() const { return queue(QueueKind::graphics); }
  const QueueRef& present() const { return queue(QueueKind::present); }
  /// True when compute and graphics are of different families: buffers then change owner (barriers.hpp).
  bool separateCompute() const { return compute().family != graphics().family; }

  bool hasSurface() const { return *surface_ != vk::SurfaceKHR{}; }
  vk::SurfaceKHR surface() const { return *surface_; }
  /// Compiled pipelines on disk; usable from any thread.
  const vk::raii::PipelineCache& pipelineCache() const { return cache_->handle(); }
  void savePipelineCache() const { cache_->save(); }
  /// The one descriptor set layout and pipeline layout of all passes (pass.hpp).
  const PassLayout& passLayout() const { return *passLayout_; }

  /// Record, submit, wait (answerTimeout at most). Returns device milliseconds, wall milliseconds without
  /// timestamps. Any thread. For repeated work keep a Commands object (commands.hpp). Throws Error(noDevice).
  double run(QueueKind kind, const Record& record) const;

  /// Lost is for ever: every later submission throws Error(noDevice) at once.
  bool lost() const { return lost_; }
  void markLost() const { lost_ = true; }
  void throwIfLost() const;

  /// First memory type of `allowedTypes` (a bit mask) with all of `properties`, -1 when there is none.
  int memoryType(std::uint32_t allowedTypes, vk::MemoryPropertyFlags properties) const;

 private:
  const QueueRef* addQueue(std::uint32_t family);
  void createDevice(const QueuePlan& plan);

  // Creation order; members die from the bottom up.
  vk::raii::Context loader_;
  vk::raii::Instance instance_;
  std::unique_ptr<DebugMessages> messages_;
  vk::raii::SurfaceKHR surface_{nullptr};
  vk::raii::PhysicalDevice physical_{nullptr};
  vk::PhysicalDeviceProperties properties_;
  vk::PhysicalDeviceMemoryProperties memory_;
  DeviceDescription description_;
  vk::raii::Device device_{nullptr};
  std::vector<std::unique_ptr<QueueRef>> queues_;
  const QueueRef* byKind_[3] = {};
  std::unique_ptr<PipelineCache> cache_;
  std::unique_ptr<PassLayout> passLayout_;
  mutable std::atomic<bool> lost_{false};
};

}  // namespace steradian::gpu
