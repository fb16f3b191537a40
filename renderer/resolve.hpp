// SPDX-License-Identifier: MIT
// The mean radiance of a film in a buffer of its own, which the display pass reads (and its queue family may
// own).
#pragma once
#include <memory>
#include <optional>

#include "renderer/film.hpp"
#include "renderer/scene/image.hpp"

namespace steradian {

/// One picture to show; a window has one per frame in flight. Keeps its film alive while the device may read
/// it.
class ResolvedPicture {
 public:
  /// Only when nothing in flight uses this picture.
  void prepare(const gpu::Device& device, std::shared_ptr<const Film> film);
  template <class Commands>
  void record(const Commands& cmd, const gpu::ComputePass& resolve, bool errorMeter) const {
    resolve.dispatch(cmd, *resolving_, film_->params(errorMeter), groupsX, groupsY());
  }
  const gpu::Buffer& buffer() const { return buffer_; }
  /// For the window's pass.
  const gpu::Bindings& displaying() const { return *displaying_; }
  Extent extent() const { return film_->extent(); }

 private:
  static constexpr std::uint32_t groupsX = 256;  // of 64 pixels each
  std::uint32_t groupsY() const;

  std::shared_ptr<const Film> film_;
  gpu::Buffer buffer_;
  std::optional<gpu::Bindings> resolving_, displaying_;
};

}  // namespace steradian
