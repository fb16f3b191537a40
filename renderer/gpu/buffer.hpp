// SPDX-License-Identifier: MIT
// Device memory for records and pixels, by need: who writes it and who reads it.
#pragma once
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "renderer/gpu/device.hpp"

namespace steradian::gpu {

enum class BufferKind {
  deviceLocal,  // storage: written and read by shaders, read by readBack()
  film,         // the same, and uniform RGBA32I texels, which CPU drivers read several times as fast
  upload,       // storage + uniform texels: scene rows; written by write(), read by shaders. Lies on the
                // device; write() goes through a staging buffer when the host cannot reach that memory
  texelRows,    // as upload, but uniform RGBA32F texels only: may be larger than one storage binding
  texelWords,   // the same with R32UI texels
  readback      // written by copies, read through map(); host memory, cached
};

/// A movable buffer with its own memory. An empty one (default) holds nothing and binds as a dummy.
class Buffer {
 public:
  Buffer() = default;
  /// `what` names it in messages ("film"). Contents are undefined. Throws Error(noDevice): "the device has
  /// not enough memory for N MiB (what)", or need and limit when one binding cannot be so large.
  Buffer(const Device& device, BufferKind kind, std::size_t bytes, std::string what);

  explicit operator bool() const { return bytes_ != 0; }
  std::size_t size() const { return bytes_; }
  vk::Buffer handle() const { return *buffer_; }
  /// The buffer as RGBA32F texels (kinds upload and texelRows, whole vec4 rows), RGBA32I (film) or R32UI
  /// texels (texelWords); null otherwise.
  vk::BufferView texels() const { return *view_; }

  /// All kinds but readback. Synchronous; wait first for submissions that use this range. Where the
  /// host cannot reach the memory a copy is run on the compute queue, which must own the buffer.
  void write(std::size_t offset, std::span<const std::byte> bytes);
  template <class Row>
  void writeRows(std::size_t offset, std::span<const Row> rows) {
    write(offset, std::as_bytes(rows));
  }
  /// Host address, or null when the host cannot reach this memory. Mapped for the buffer's life, coherent.
  std::byte* map() const { return mapped_; }

 private:
  void checkLimits(BufferKind kind) const;
  bool allocate(vk::MemoryPropertyFlags properties);
  void allocateFor(BufferKind kind);
  void createView(BufferKind kind);

  const Device* device_ = nullptr;
  std::size_t bytes_ = 0;
  std::string what_;
  vk::raii::DeviceMemory memory_{nullptr};  // before the buffer, which must die first
  vk::raii::Buffer buffer_{nullptr};
  vk::raii::BufferView view_{nullptr};
  std::byte* mapped_ = nullptr;
};

/// [offset, offset + bytes) in host memory, copied on the queue that owns the buffer; waits for earlier
/// submissions to that queue by a barrier. Offsets and sizes are multiples of 4 bytes, at least 4.
Buffer readBack(const Device& device, const Buffer& buffer, std::size_t offset, std::size_t bytes,
                QueueKind owner = QueueKind::compute);

/// The same as an array of T, which may be empty.
template <class T>
std::vector<T> downloadAs(const Device& device, const Buffer& buffer, std::size_t firstByte,
                          std::size_t count, QueueKind owner = QueueKind::compute) {
  std::vector<T> values(count);
  if (count > 0) {
    const Buffer bytes = readBack(device, buffer, firstByte, count * sizeof(T), owner);
    std::memcpy(values.data(), bytes.map(), count * sizeof(T));
  }
  return values;
}

/// Zeroes the whole buffer and waits for it.
void fillZero(const Device& device, const Buffer& buffer, QueueKind owner = QueueKind::compute);
/// The same as a command with the barriers around it (earlier shader accesses before, later ones after).
void recordFillZero(const vk::raii::CommandBuffer& cmd, const Buffer& buffer);

}  // namespace steradian::gpu
