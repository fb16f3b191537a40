// SPDX-License-Identifier: MIT
// Allocation, and copies to and from the host.
#include "renderer/gpu/buffer.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "renderer/gpu/barriers.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::gpu {
namespace {

using Usage = vk::BufferUsageFlagBits;
using Memory = vk::MemoryPropertyFlagBits;

// Undefined = no texel view.
vk::Format texelFormat(BufferKind kind) {
  switch (kind) {
    case BufferKind::film:
      return vk::Format::eR32G32B32A32Sint;
    case BufferKind::upload:
    case BufferKind::texelRows:
      return vk::Format::eR32G32B32A32Sfloat;
    case BufferKind::texelWords:
      return vk::Format::eR32Uint;
    default:
      return vk::Format::eUndefined;
  }
}
std::size_t texelBytes(BufferKind kind) {
  if (texelFormat(kind) == vk::Format::eUndefined) return 0;
  return kind == BufferKind::texelWords ? 4 : 16;
}
bool holdsStorage(BufferKind kind) {
  return kind == BufferKind::deviceLocal || kind == BufferKind::film || kind == BufferKind::upload;
}
constexpr vk::MemoryPropertyFlags onHost = Memory::eHostVisible | Memory::eHostCoherent;

vk::BufferUsageFlags usageOf(BufferKind kind) {
  const vk::BufferUsageFlags copies = Usage::eTransferSrc | Usage::eTransferDst;
  switch (kind) {
    case BufferKind::deviceLocal:
      return copies | Usage::eStorageBuffer;
    case BufferKind::film:
    case BufferKind::upload:
      return copies | Usage::eStorageBuffer | Usage::eUniformTexelBuffer;
    case BufferKind::texelRows:
    case BufferKind::texelWords:
      return copies | Usage::eUniformTexelBuffer;
    default:
      return copies;
  }
}

// What to ask of the memory, best first; the last must exist on every device (Vulkan 1.2, 11.2).
std::vector<vk::MemoryPropertyFlags> wishesOf(BufferKind kind) {
  switch (kind) {
    case BufferKind::deviceLocal:
    case BufferKind::film:
      return {Memory::eDeviceLocal, {}};
    case BufferKind::upload:
    case BufferKind::texelRows:
    case BufferKind::texelWords:
      return {Memory::eDeviceLocal | onHost, Memory::eDeviceLocal, {}};
    default:
      return {onHost | Memory::eHostCached, onHost};
  }
}

std::string inMebibytes(std::size_t bytes) {
  return std::to_string((bytes + (1u << 20) - 1) >> 20) + " MiB";
}

bool outOfMemory(const vk::SystemError& error) {
  const auto result = static_cast<vk::Result>(error.code().value());
  return result == vk::Result::eErrorOutOfDeviceMemory || result == vk::Result::eErrorOutOfHostMemory;
}

}  // namespace

Buffer::Buffer(const Device& device, BufferKind kind, std::size_t bytes, std::string what)
    : device_(&device), bytes_(bytes), what_(std::move(what)) {
  assert(bytes > 0);
  checkLimits(kind);
  const vk::BufferCreateInfo info({}, bytes, usageOf(kind));
  checked(device, "creating a buffer", [&] { buffer_ = vk::raii::Buffer(device.handle(), info); });
  allocateFor(kind);
  if (texelBytes(kind) != 0 && bytes % texelBytes(kind) == 0) createView(kind);
}

void Buffer::checkLimits(BufferKind kind) const {
  std::size_t limit = ~std::size_t(0);
  if (holdsStorage(kind)) limit = device_->limits().maxStorageBufferRange;
  if (texelBytes(kind) != 0)
    limit = std::min(limit, std::size_t(device_->limits().maxTexelBufferElements) * texelBytes(kind));
  if (bytes_ > limit)
    throw Error(ExitCode::noDevice, device_->description().name + ": the " + what_ + " needs " +
                                        inMebibytes(bytes_) + ", the device allows " +
                                        std::to_string(limit >> 20) + " MiB in one buffer");
}

bool Buffer::allocate(vk::MemoryPropertyFlags properties) {
  const vk::MemoryRequirements needs = buffer_.getMemoryRequirements();
  const int type = device_->memoryType(needs.memoryTypeBits, properties);
  if (type < 0) return false;
  try {
    memory_ = vk::raii::DeviceMemory(device_->handle(), vk::MemoryAllocateInfo(needs.size, type));
    return true;
  } catch (const vk::SystemError& error) {
    if (outOfMemory(error)) return false;  // another heap may have room
    raise(*device_, "allocating memory (" + what_ + ")", error);
  }
}

void Buffer::allocateFor(BufferKind kind) {
  for (const vk::MemoryPropertyFlags& wish : wishesOf(kind)) {
    if (!allocate(wish)) continue;
    const bool reachable = bool(wish & Memory::eHostVisible);
    checked(*device_, "binding memory", [&] {
      buffer_.bindMemory(*memory_, 0);
      if (reachable) mapped_ = static_cast<std::byte*>(memory_.mapMemory(0, VK_WHOLE_SIZE));
    });
    return;
  }
  throw Error(ExitCode::noDevice, device_->description().name + ": the device has not enough memory for " +
                                      inMebibytes(bytes_) + " (" + what_ + ")");
}

void Buffer::createView(BufferKind kind) {
  const vk::BufferViewCreateInfo info({}, *buffer_, texelFormat(kind), 0, VK_WHOLE_SIZE);
  checked(*device_, "creating a texel view", [&] { view_ = vk::raii::BufferView(device_->handle(), info); });
}

void Buffer::write(std::size_t offset, std::span<const std::byte> bytes) {
  assert(offset + bytes.size() <= bytes_);
  if (bytes.empty()) return;
  if (mapped_) {
    std::memcpy(mapped_ + offset, bytes.data(), bytes.size());
    return;
  }
  const Buffer staging(*device_, BufferKind::readback, bytes.size(), what_ + ", staging");
  std::memcpy(staging.map(), bytes.data(), bytes.size());
  device_->run(QueueKind::compute, [&](const vk::raii::CommandBuffer& cmd) {
    computeToTransfer(cmd);
    cmd.copyBuffer(staging.handle(), *buffer_, vk::BufferCopy(0, offset, bytes.size()));
    transferToCompute(cmd);
  });
}

Buffer readBack(const Device& device, const Buffer& buffer, std::size_t offset, std::size_t bytes,
                QueueKind owner) {
  assert(bytes > 0 && offset + bytes <= buffer.size());
  Buffer staging(device, BufferKind::readback, bytes, "read-back");
  device.run(owner, [&](const vk::raii::CommandBuffer& cmd) {
    computeToTransfer(cmd);
    cmd.copyBuffer(buffer.handle(), staging.handle(), vk::BufferCopy(offset, 0, bytes));
    transferToHost(cmd);
  });
  return staging;
}

void fillZero(const Device& device, const Buffer& buffer, QueueKind owner) {
  device.run(owner, [&](const vk::raii::CommandBuffer& cmd) { recordFillZero(cmd, buffer); });
}

void recordFillZero(const vk::raii::CommandBuffer& cmd, const Buffer& buffer) {
  computeToTransfer(cmd);
  cmd.fillBuffer(buffer.handle(), 0, VK_WHOLE_SIZE, 0);
  transferToCompute(cmd);
}

}  // namespace steradian::gpu
