// SPDX-License-Identifier: MIT
// Counts what the validation layer says and prints each message once.
#pragma once
#include <memory>
#include <vulkan/vulkan_raii.hpp>

namespace steradian::gpu {

/// Warnings and errors of core and synchronization validation; any thread may report, any may ask.
class DebugMessages {
 public:
  /// Listens until destroyed. Needs VK_EXT_debug_utils on the instance.
  explicit DebugMessages(const vk::raii::Instance& instance);
  ~DebugMessages();
  int count() const;

 private:
  struct Log;
  std::unique_ptr<Log> log_;  // before the messenger, which points at it
  vk::raii::DebugUtilsMessengerEXT messenger_;
};

}  // namespace steradian::gpu
