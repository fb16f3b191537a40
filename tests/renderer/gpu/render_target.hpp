// SPDX-License-Identifier: MIT
// An offscreen RGBA32F picture: what a pass would draw into the window, read back for the tests.
#pragma once
#include <vulkan/vulkan_raii.hpp>

#include "renderer/gpu/buffer.hpp"
#include "renderer/gpu/device.hpp"
#include "renderer/presenter.hpp"
#include "renderer/renderer.hpp"
#include "renderer/scene/image.hpp"

namespace steradian::gpu {

/// One thread at a time. The render pass depends on nothing but the format, so pipelines made for one
/// RenderTarget fit all.
class RenderTarget {
 public:
  /// Throws Error(noDevice) when the picture is larger than the device allows or memory is short.
  RenderTarget(const Device& device, Extent extent);

  vk::RenderPass renderPass() const { return *renderPass_; }
  Extent extent() const { return extent_; }
  PixelRect rect() const { return {0, 0, extent_.width, extent_.height}; }

  /// One submission on the graphics queue: `before` (outside the render pass: barriers, acquire), `draw`
  /// (inside, cleared to black), `after` (outside: release), read-back. Returns 3 channels as written.
  Image render(const Record& draw, const Record& before = {}, const Record& after = {});

 private:
  void createImage();
  void createFramebuffer();
  Image toImage() const;

  const Device& device_;
  Extent extent_;
  vk::raii::RenderPass renderPass_;
  vk::raii::DeviceMemory memory_{nullptr};
  vk::raii::Image image_{nullptr};
  vk::raii::ImageView view_{nullptr};
  vk::raii::Framebuffer framebuffer_{nullptr};
  Buffer pixels_;
};

}  // namespace steradian::gpu
