// SPDX-License-Identifier: MIT
#include "renderer/resolve.hpp"

namespace steradian {

using namespace gpu;

void ResolvedPicture::prepare(const Device& device, std::shared_ptr<const Film> film) {
  if (film == film_) return;
  const std::size_t bytes = film->pixels() * 16;
  resolving_.reset();
  displaying_.reset();
  if (buffer_.size() < bytes) buffer_ = Buffer(device, BufferKind::deviceLocal, bytes, "resolved film");
  film_ = std::move(film);
  const Buffer* const shown[] = {nullptr, nullptr, nullptr, nullptr, &buffer_};
  gpu::TexelBuffers read;
  read.film = film_->texels();
  resolving_.emplace(device, read, shown);
  displaying_.emplace(device, gpu::TexelBuffers{}, shown);
}

std::uint32_t ResolvedPicture::groupsY() const {
  const std::size_t perRow = groupsX * 64;
  return std::uint32_t((film_->pixels() + perRow - 1) / perRow);
}

}  // namespace steradian
