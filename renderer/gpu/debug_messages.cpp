// SPDX-License-Identifier: MIT
// The messenger of VK_EXT_debug_utils.
#include "renderer/gpu/debug_messages.hpp"

#include <atomic>
#include <cstdio>
#include <mutex>
#include <set>
#include <string>

namespace steradian::gpu {

struct DebugMessages::Log {
  std::atomic<int> count{0};
  std::mutex mutex;
  std::set<std::string> printed;

  void add(const VkDebugUtilsMessengerCallbackDataEXT& message) {
    ++count;
    const std::lock_guard lock(mutex);
    const std::string id = message.pMessageIdName ? message.pMessageIdName : message.pMessage;
    if (printed.insert(id).second) std::fprintf(stderr, "Vulkan validation: %s\n", message.pMessage);
  }
};

namespace {

constexpr auto severities =
    vk::DebugUtilsMessageSeverityFlagBitsEXT::eWarning | vk::DebugUtilsMessageSeverityFlagBitsEXT::eError;

}  // namespace

DebugMessages::DebugMessages(const vk::raii::Instance& instance)
    : log_(std::make_unique<Log>()), messenger_(nullptr) {
  // No exception may pass through the driver, so the callback is the edge.
  const auto callback = [](VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                           const VkDebugUtilsMessengerCallbackDataEXT* message, void* log) -> VkBool32 {
    try {
      static_cast<Log*>(log)->add(*message);
    } catch (const std::exception&) {
    }
    return VK_FALSE;
  };
  const vk::DebugUtilsMessengerCreateInfoEXT info(
      {}, severities, vk::DebugUtilsMessageTypeFlagBitsEXT::eValidation, callback, log_.get());
  messenger_ = vk::raii::DebugUtilsMessengerEXT(instance, info);
}

DebugMessages::~DebugMessages() = default;

int DebugMessages::count() const {
  return log_->count;
}

}  // namespace steradian::gpu
