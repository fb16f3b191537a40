// SPDX-License-Identifier: MIT
// Memory barriers by purpose.
#include "renderer/gpu/barriers.hpp"

namespace steradian::gpu {
namespace {

using Stage = vk::PipelineStageFlagBits;
using Access = vk::AccessFlagBits;

void barrier(const vk::raii::CommandBuffer& cmd, vk::PipelineStageFlags from, vk::AccessFlags written,
             vk::PipelineStageFlags to, vk::AccessFlags used) {
  cmd.pipelineBarrier(from, to, {}, vk::MemoryBarrier(written, used), {}, {});
}

// All stages: the same words then fit queues with and without graphics, and they chain with the semaphore.
void changeOwner(const vk::raii::CommandBuffer& cmd, const Buffer& buffer, std::uint32_t fromFamily,
                 std::uint32_t toFamily, vk::AccessFlags written, vk::AccessFlags used) {
  if (fromFamily == toFamily || !buffer) return;
  const vk::BufferMemoryBarrier transfer(written, used, fromFamily, toFamily, buffer.handle(), 0,
                                         VK_WHOLE_SIZE);
  cmd.pipelineBarrier(Stage::eAllCommands, Stage::eAllCommands, {}, {}, transfer, {});
}

}  // namespace

void computeToCompute(const vk::raii::CommandBuffer& cmd) {
  barrier(cmd, Stage::eComputeShader, Access::eShaderWrite, Stage::eComputeShader,
          Access::eShaderRead | Access::eShaderWrite);
}

void computeToTransfer(const vk::raii::CommandBuffer& cmd) {
  barrier(cmd, Stage::eComputeShader | Stage::eTransfer, Access::eShaderWrite | Access::eTransferWrite,
          Stage::eTransfer, Access::eTransferRead | Access::eTransferWrite);
}

void computeToHost(const vk::raii::CommandBuffer& cmd) {
  barrier(cmd, Stage::eComputeShader, Access::eShaderWrite, Stage::eHost, Access::eHostRead);
}

void transferToCompute(const vk::raii::CommandBuffer& cmd) {
  barrier(cmd, Stage::eTransfer, Access::eTransferWrite, Stage::eComputeShader,
          Access::eShaderRead | Access::eShaderWrite);
}

void transferToHost(const vk::raii::CommandBuffer& cmd) {
  barrier(cmd, Stage::eTransfer, Access::eTransferWrite, Stage::eHost, Access::eHostRead);
}

void release(const vk::raii::CommandBuffer& cmd, const Buffer& buffer, std::uint32_t fromFamily,
             std::uint32_t toFamily) {
  changeOwner(cmd, buffer, fromFamily, toFamily, Access::eMemoryWrite, {});
}

void acquire(const vk::raii::CommandBuffer& cmd, const Buffer& buffer, std::uint32_t fromFamily,
             std::uint32_t toFamily) {
  changeOwner(cmd, buffer, fromFamily, toFamily, {}, Access::eMemoryRead | Access::eMemoryWrite);
}

void handOver(const Device& device, std::span<const Buffer* const> buffers, QueueKind from, QueueKind to) {
  const std::uint32_t fromFamily = device.queue(from).family, toFamily = device.queue(to).family;
  if (fromFamily == toFamily) return;
  device.run(from, [&](const vk::raii::CommandBuffer& cmd) {
    for (const Buffer* buffer : buffers) release(cmd, *buffer, fromFamily, toFamily);
  });
  device.run(to, [&](const vk::raii::CommandBuffer& cmd) {
    for (const Buffer* buffer : buffers) acquire(cmd, *buffer, fromFamily, toFamily);
  });
}

}  // namespace steradian::gpu
