// SPDX-License-Identifier: MIT
// The window's images: acquire, draw, present; resize, minimise and lost surfaces are handled here.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "renderer/gpu/buffer.hpp"
#include "renderer/gpu/commands.hpp"
#include "renderer/gpu/device.hpp"
#include "renderer/presenter.hpp"
#include "renderer/scene/image.hpp"

namespace steradian::gpu {

/// A frame that is being recorded; belongs to the Swapchain, valid from begin() to end().
struct Frame {
  const vk::raii::CommandBuffer& cmd;
  /// The command buffer as others know it (a UI's backend).
  void* native() const { return static_cast<VkCommandBuffer>(*cmd); }
  std::uint32_t imageIndex;
  std::uint32_t slot;  // of the two frames in flight
  Extent extent;       // of the image; may differ from the framebuffer asked for while a window is resized
};

/// One thread. Encoded values are written by our shaders, so the format is UNORM, never _SRGB. Two frames are
/// in flight.
class Swapchain {
 public:
  static constexpr std::uint32_t framesInFlight = 2;

  /// Throws Error(noDevice) when the surface cannot be presented to. A mode that does not exist becomes fifo.
  Swapchain(const Device& device, Extent framebuffer, PresentMode mode);
  ~Swapchain();

  /// Every frame that begin() gives goes to end(); one that an exception kept from it is begun again.
  /// Absent when nothing can be shown now (minimised, no image within a second): skip the frame.
  /// Recreates the swapchain when `framebuffer` or the surface changed. Throws Error(noDevice).
  std::optional<Frame> begin(Extent framebuffer);
  /// Clears to dark grey; the contents of the render pass may draw anywhere in frame.extent.
  void beginRenderPass(const Frame& frame);
  void endRenderPass(const Frame& frame);
  /// Submits on the graphics queue and presents. `waits` and `signals` join it with the compute queue.
  void end(const Frame& frame, std::span<const Wait> waits = {}, std::span<const vk::Semaphore> signals = {});

  void setMode(PresentMode mode);
  PresentMode mode() const { return mode_; }
  std::vector<PresentMode> availableModes() const;
  /// Stays the same through resizes: pipelines and ImGui may keep it.
  vk::RenderPass renderPass() const { return *renderPass_; }
  /// What a UI's Vulkan backend is initialised with.
  Presenter::Handles handles() const;
  std::uint32_t imageCount() const { return std::uint32_t(images_.size()); }
  Extent extent() const { return extent_; }

  /// The last frame that end() submitted, 3 channels in [0, 1]. Every frame is copied for this unless
  /// keepFrames(false). Throws Error(failed) when there is none or the surface's images cannot be read.
  Image screenshot();
  void keepFrames(bool keep) { keepFrames_ = keep; }

 private:
  struct PerImage {
    vk::Image image;
    vk::raii::ImageView view;
    vk::raii::Framebuffer framebuffer;
    vk::raii::Semaphore rendered;  // signalled by our submission, waited for by the presentation
  };
  void chooseFormat();
  void createRenderPass();
  bool recreate(Extent framebuffer);
  void createSwapchain(const vk::SurfaceCapabilitiesKHR& capabilities, Extent extent);
  void createImages();
  std::optional<std::uint32_t> acquire(Extent framebuffer);
  std::optional<std::uint32_t> acquireOnce();
  void recordCopy(const Frame& frame);
  void present(const Frame& frame);
  void waitForFrames();

  const Device& device_;
  PresentMode mode_;
  vk::SurfaceFormatKHR format_;
  vk::raii::RenderPass renderPass_{nullptr};
  Extent extent_;       // of the images
  Extent framebuffer_;  // last asked for
  bool stale_ = true;
  bool readable_ = false;  // images may be copied from
  bool keepFrames_ = true;
  bool keptFrame_ = false;
  Extent keptExtent_;
  vk::raii::SwapchainKHR swapchain_{nullptr};
  std::vector<PerImage> images_;
  std::vector<vk::raii::Semaphore> acquired_;        // one per slot
  std::vector<std::unique_ptr<Commands>> commands_;  // one per slot
  std::uint32_t slot_ = 0;
  std::optional<std::uint32_t> open_;  // acquired and not yet presented (an exception came in between)
  Buffer kept_;                        // the last frame's pixels
};

}  // namespace steradian::gpu
