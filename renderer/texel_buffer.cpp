// SPDX-License-Identifier: MIT
#include "renderer/texel_buffer.hpp"

#include <algorithm>

namespace steradian {
namespace {

// Where the host cannot reach device memory a copy goes through memory of this size.
constexpr std::size_t wordsAtOnce = 1 << 24;

}  // namespace

gpu::Buffer texelBuffer(const gpu::Device& device, const GpuScene& scene) {
  const std::vector<std::uint32_t> tables = texelTables(scene.textures);
  std::size_t words = tables.size();
  for (const auto& texture : scene.textures) words += texture->words.size();
  if (words == 0) return {};
  gpu::Buffer buffer(device, gpu::BufferKind::texelWords, words * sizeof(std::uint32_t), "texture data");
  std::size_t at = 0;
  const auto write = [&](std::span<const std::uint32_t> part) {
    for (std::size_t first = 0; first < part.size(); first += wordsAtOnce) {
      const auto piece = part.subspan(first, std::min(wordsAtOnce, part.size() - first));
      buffer.writeRows(at * sizeof(std::uint32_t), piece);
      at += piece.size();
    }
  };
  write(tables);
  for (const auto& texture : scene.textures) write(texture->words);
  return buffer;
}

}  // namespace steradian
