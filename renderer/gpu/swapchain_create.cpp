// SPDX-License-Identifier: MIT
// Making and remaking the swapchain: format, size, present mode, images.
#include <algorithm>
#include <limits>

#include "renderer/gpu/swapchain.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::gpu {
namespace {

constexpr vk::ImageUsageFlags drawn = vk::ImageUsageFlagBits::eColorAttachment;
constexpr vk::ImageUsageFlags read = vk::ImageUsageFlagBits::eTransferSrc;

vk::PresentModeKHR toVulkan(PresentMode mode) {
  switch (mode) {
    case PresentMode::mailbox:
      return vk::PresentModeKHR::eMailbox;
    case PresentMode::immediate:
      return vk::PresentModeKHR::eImmediate;
    default:
      return vk::PresentModeKHR::eFifo;
  }
}

// Wayland leaves the size to us (all ones); elsewhere the surface dictates it.
Extent extentOf(const vk::SurfaceCapabilitiesKHR& capabilities, Extent framebuffer) {
  const vk::Extent2D current = capabilities.currentExtent;
  if (current.width != std::numeric_limits<std::uint32_t>::max())
    return {int(current.width), int(current.height)};
  const auto within = [](int wanted, std::uint32_t least, std::uint32_t most) {
    return wanted <= 0 ? 0 : std::clamp(wanted, int(least), int(most));
  };
  return {within(framebuffer.width, capabilities.minImageExtent.width, capabilities.maxImageExtent.width),
          within(framebuffer.height, capabilities.minImageExtent.height, capabilities.maxImageExtent.height)};
}

vk::CompositeAlphaFlagBitsKHR alphaOf(const vk::SurfaceCapabilitiesKHR& capabilities) {
  using Alpha = vk::CompositeAlphaFlagBitsKHR;
  for (const Alpha alpha : {Alpha::eOpaque, Alpha::eInherit, Alpha::ePreMultiplied, Alpha::ePostMultiplied})
    if (capabilities.supportedCompositeAlpha & alpha) return alpha;
  return Alpha::eOpaque;
}

}  // namespace

void Swapchain::chooseFormat() {
  const auto formats = checked(device_, "asking the window for its formats",
                               [&] { return device_.physical().getSurfaceFormatsKHR(device_.surface()); });
  for (const vk::Format wanted : {vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm})
    for (const vk::SurfaceFormatKHR& format : formats)
      if (format.format == wanted && format.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear) {
        format_ = format;
        return;
      }
  throw Error(ExitCode::noDevice, device_.description().name +
                                      ": the window offers no 8-bit UNORM format in sRGB; stills can be made "
                                      "without a window: steradian render");
}

void Swapchain::createRenderPass() {
  vk::AttachmentDescription colour;
  colour.format = format_.format;
  colour.loadOp = vk::AttachmentLoadOp::eClear;
  colour.storeOp = vk::AttachmentStoreOp::eStore;
  colour.finalLayout = vk::ImageLayout::ePresentSrcKHR;
  const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
  vk::SubpassDescription subpass;
  subpass.setColorAttachments(reference);
  // The layout change must come after the image was acquired, whose semaphore is waited for in this stage.
  const auto output = vk::PipelineStageFlagBits::eColorAttachmentOutput;
  const auto write = vk::AccessFlagBits::eColorAttachmentWrite;
  const vk::SubpassDependency dependency(VK_SUBPASS_EXTERNAL, 0, output, output, {}, write);
  const vk::RenderPassCreateInfo info({}, colour, subpass, dependency);
  checked(device_, "creating a render pass",
          [&] { renderPass_ = vk::raii::RenderPass(device_.handle(), info); });
}

std::vector<PresentMode> Swapchain::availableModes() const {
  const auto modes = checked(device_, "asking the window for its present modes",
                             [&] { return device_.physical().getSurfacePresentModesKHR(device_.surface()); });
  std::vector<PresentMode> available;
  for (const PresentMode mode : {PresentMode::fifo, PresentMode::mailbox, PresentMode::immediate})
    if (std::find(modes.begin(), modes.end(), toVulkan(mode)) != modes.end()) available.push_back(mode);
  return available;
}

void Swapchain::setMode(PresentMode mode) {
  const std::vector<PresentMode> available = availableModes();
  const bool exists = std::find(available.begin(), available.end(), mode) != available.end();
  const PresentMode usable = exists ? mode : PresentMode::fifo;
  stale_ = stale_ || usable != mode_;
  mode_ = usable;
}

// False when the window has no area now.
bool Swapchain::recreate(Extent framebuffer) {
  waitForFrames();
  if (open_) acquired_[slot_] = makeSemaphore(device_);  // the old one stays signalled
  open_.reset();
  const auto capabilities = checked(device_, "asking the window for its size", [&] {
    return device_.physical().getSurfaceCapabilitiesKHR(device_.surface());
  });
  framebuffer_ = framebuffer;
  stale_ = true;
  const Extent extent = extentOf(capabilities, framebuffer);
  if (extent.width == 0 || extent.height == 0) return false;
  if (framebuffer.width <= 0 || framebuffer.height <= 0) return false;
  checked(device_, "creating the window's images", [&] {
    createSwapchain(capabilities, extent);
    createImages();
  });
  stale_ = false;
  return true;
}

void Swapchain::createSwapchain(const vk::SurfaceCapabilitiesKHR& capabilities, Extent extent) {
  images_.clear();
  readable_ = bool(capabilities.supportedUsageFlags & read);
  vk::SwapchainCreateInfoKHR info;
  info.surface = device_.surface();
  info.minImageCount = capabilities.minImageCount + 1;  // so that one can be drawn while one is shown
  if (capabilities.maxImageCount)
    info.minImageCount = std::min(info.minImageCount, capabilities.maxImageCount);
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = vk::Extent2D(std::uint32_t(extent.width), std::uint32_t(extent.height));
  info.imageArrayLayers = 1;
  info.imageUsage = readable_ ? drawn | read : drawn;
  const std::array families = {device_.graphics().family, device_.present().family};
  if (families[0] != families[1]) {  // shared: images need no change of owner between drawing and presenting
    info.imageSharingMode = vk::SharingMode::eConcurrent;
    info.setQueueFamilyIndices(families);
  }
  info.preTransform = capabilities.currentTransform;
  info.compositeAlpha = alphaOf(capabilities);
  info.presentMode = toVulkan(mode_);
  info.clipped = !readable_;  // hidden pixels must be drawn too when frames are kept
  info.oldSwapchain = *swapchain_;
  vk::raii::SwapchainKHR created(device_.handle(), info);
  swapchain_ = std::move(created);
  extent_ = extent;
}

void Swapchain::createImages() {
  const vk::ImageSubresourceRange whole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
  for (const VkImage handle : swapchain_.getImages()) {
    const vk::Image image = handle;
    vk::raii::ImageView view(device_.handle(),
                             {{}, image, vk::ImageViewType::e2D, format_.format, {}, whole});
    const vk::ImageView attachment = *view;
    const vk::FramebufferCreateInfo info({}, *renderPass_, attachment, std::uint32_t(extent_.width),
                                         std::uint32_t(extent_.height), 1);
    vk::raii::Framebuffer framebuffer(device_.handle(), info);
    images_.push_back({image, std::move(view), std::move(framebuffer), makeSemaphore(device_)});
  }
  if (!readable_) return;
  kept_ = Buffer(device_, BufferKind::readback, std::size_t(extent_.width) * std::size_t(extent_.height) * 4,
                 "last frame");
  keptFrame_ = false;
}

}  // namespace steradian::gpu
