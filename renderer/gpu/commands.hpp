// SPDX-License-Identifier: MIT
// A reusable recording and its submission: command buffer, fence, and a pair of timestamps around it.
#pragma once
#include <chrono>
#include <span>
#include <vulkan/vulkan_raii.hpp>

#include "renderer/gpu/device.hpp"

namespace steradian::gpu {

/// A submission that has not answered for so long is taken for lost. A driver that computes on the CPU shares
/// it with everything else, and compiles a shader during its first dispatch.
std::chrono::seconds answerTimeout(const Device& device);

using Semaphore = vk::raii::Semaphore;

/// The stage of a frame that reads what the compute queue resolved.
inline constexpr auto frameReadsPicture = vk::PipelineStageFlagBits::eFragmentShader;

struct Wait {
  vk::Semaphore semaphore;
  vk::PipelineStageFlags stage = vk::PipelineStageFlagBits::eAllCommands;
};

/// One submission in flight at a time. Belongs to one thread at a time (it owns its command pool); different
/// threads use different Commands on the same queue freely. The destructor waits for what is in flight, up to
/// answerTimeout, also when the device is taken for lost.
class Commands {
 public:
  Commands(const Device& device, QueueKind kind);
  ~Commands();
  Commands(Commands&&) = delete;

  /// Waits for the submission before, then starts recording.
  const vk::raii::CommandBuffer& begin();
  /// Ends the recording and submits it. Throws Error(noDevice).
  void submit(std::span<const Wait> waits = {}, std::span<const vk::Semaphore> signals = {});
  /// begin(), record, submit().
  void submit(const Record& record, std::span<const Wait> waits = {},
              std::span<const vk::Semaphore> signals = {});
  /// True when nothing is in flight. Never blocks. Throws Error(noDevice) when the device was lost.
  bool done();
  /// Blocks until done. Throws Error(noDevice) when the device was lost or does not answer in time.
  void wait();
  /// submit(), wait(), milliseconds().
  double run(const Record& record);

  /// Device time of the last finished submission, or wall time (submit to seen done) without timestamps.
  double milliseconds() const { return milliseconds_; }
  std::uint32_t family() const { return queue_.family; }

 private:
  void finish();

  const Device& device_;
  const QueueRef& queue_;
  vk::raii::CommandPool pool_;
  vk::raii::CommandBuffer buffer_;
  vk::raii::Fence fence_;
  vk::raii::QueryPool timestamps_{nullptr};
  bool inFlight_ = false;
  double milliseconds_ = 0.0;
  std::chrono::steady_clock::time_point submitted_;
};

vk::raii::Semaphore makeSemaphore(const Device& device);

}  // namespace steradian::gpu
