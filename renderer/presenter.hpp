// SPDX-License-Identifier: MIT
// The window side of a device: swapchain, the viewport drawn into a rectangle, an overlay (the UI) over it.
#pragma once
#include <functional>
#include <memory>

#include "renderer/renderer.hpp"

namespace steradian {

struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;  // framebuffer pixels from the top left
  bool operator==(const PixelRect&) const = default;
};

enum class PresentMode { fifo, mailbox, immediate };

/// One frame at a time, on the thread of the Renderer. Handles resize, minimise and out-of-date swapchains.
class Presenter {
 public:
  Presenter(std::shared_ptr<gpu::Device> device, Extent framebuffer, PresentMode mode);
  ~Presenter();

  /// Draw the renderer's picture into `viewport`, then `overlay(vkCommandBuffer)` inside the same render
  /// pass. False when nothing could be shown (minimised). Throws Error(noDevice) on device loss or time-out.
  bool present(Renderer& renderer, Extent framebuffer, PixelRect viewport,
               const std::function<void(void* vkCommandBuffer)>& overlay);

  void setPresentMode(PresentMode mode);  // falls back to fifo when the surface has no such mode
  std::vector<PresentMode> availableModes() const;

  /// What ImGui's Vulkan backend needs, as opaque handles (read by editor/ui/imgui_vulkan.cpp only).
  struct Handles {
    void* instance;
    void* physicalDevice;
    void* device;
    void* queue;
    std::uint32_t queueFamily;
    std::uint64_t renderPass;
    std::uint32_t imageCount;
  };
  Handles handles() const;

  /// The last presented frame as display-encoded RGB (tests and screenshots).
  Image screenshot();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace steradian
