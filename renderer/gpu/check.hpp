// SPDX-License-Identifier: MIT
// The one place where a failed Vulkan call becomes a steradian::Error in plain words.
#pragma once
#include <string>
#include <utility>
#include <vulkan/vulkan_raii.hpp>

namespace steradian::gpu {

class Device;

/// What a result code means and what to do about it, in words for the user.
std::string plainWords(vk::Result result);

/// Throws Error(noDevice) "`doing` failed: <plain words>". Device loss is remembered by `device`.
[[noreturn]] void raise(const Device& device, const std::string& doing, const vk::SystemError& error);

/// Runs `call()` and turns vk::SystemError into Error(noDevice), which says what we were `doing`.
template <class Call>
decltype(auto) checked(const Device& device, const char* doing, Call&& call) {
  try {
    return std::forward<Call>(call)();
  } catch (const vk::SystemError& error) {
    raise(device, doing, error);
  }
}

}  // namespace steradian::gpu
