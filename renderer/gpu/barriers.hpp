// SPDX-License-Identifier: MIT
// What has to be said between two commands that touch the same memory, and between two queue families.
#pragma once
#include <cstdint>
#include <span>
#include <vulkan/vulkan_raii.hpp>

#include "renderer/gpu/buffer.hpp"
#include "renderer/gpu/device.hpp"

namespace steradian::gpu {

/// Compute writes, then compute reads or writes (also between submissions to one queue).
void computeToCompute(const vk::raii::CommandBuffer& cmd);
void computeToTransfer(const vk::raii::CommandBuffer& cmd);
void computeToHost(const vk::raii::CommandBuffer& cmd);
void transferToCompute(const vk::raii::CommandBuffer& cmd);
void transferToHost(const vk::raii::CommandBuffer& cmd);

/// Queue family ownership: record release on the queue of `fromFamily`, signal a semaphore, wait for it on
/// the queue of `toFamily` and record acquire there. Both are no-ops when the families are equal. Outside of
/// render passes.
void release(const vk::raii::CommandBuffer& cmd, const Buffer& buffer, std::uint32_t fromFamily,
             std::uint32_t toFamily);
void acquire(const vk::raii::CommandBuffer& cmd, const Buffer& buffer, std::uint32_t fromFamily,
             std::uint32_t toFamily);

/// Release and acquire at once, waiting for both (stills; a frame uses the pair with a semaphore).
void handOver(const Device& device, std::span<const Buffer* const> buffers, QueueKind from, QueueKind to);

}  // namespace steradian::gpu
