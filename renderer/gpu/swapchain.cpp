// SPDX-License-Identifier: MIT
// One frame: acquire, record, submit, present. How the swapchain is made lies in swapchain_create.cpp.
#include "renderer/gpu/swapchain.hpp"

#include <cassert>
#include <chrono>
#include <cstring>

#include "renderer/gpu/barriers.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::gpu {
namespace {

constexpr std::chrono::nanoseconds acquireTimeout = std::chrono::seconds(1);
constexpr std::array<float, 4> darkGrey = {0.1f, 0.1f, 0.1f, 1.0f};

vk::ImageMemoryBarrier layoutChange(vk::Image image, vk::ImageLayout from, vk::ImageLayout to,
                                    vk::AccessFlags written, vk::AccessFlags used) {
  return {written,
          used,
          from,
          to,
          VK_QUEUE_FAMILY_IGNORED,
          VK_QUEUE_FAMILY_IGNORED,
          image,
          {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}};
}

}  // namespace

Swapchain::Swapchain(const Device& device, Extent framebuffer, PresentMode mode)
    : device_(device), mode_(mode) {
  assert(device.hasSurface());
  chooseFormat();
  createRenderPass();
  for (std::uint32_t i = 0; i < framesInFlight; ++i) {
    acquired_.push_back(makeSemaphore(device));
    commands_.push_back(std::make_unique<Commands>(device, QueueKind::graphics));
  }
  setMode(mode);
  recreate(framebuffer);
}

Swapchain::~Swapchain() {
  try {
    waitForFrames();
  } catch (const std::exception&) {  // lost: nothing is running any more
  }
}

void Swapchain::waitForFrames() {
  if (device_.lost()) return;
  for (const auto& commands : commands_) commands->wait();
  // The fences above had their time-out; what is left are presentations, which have no fence.
  checked(device_, "waiting for the window", [&] {
    const std::lock_guard lock(device_.present().mutex);
    device_.present().handle.waitIdle();
  });
}

std::optional<Frame> Swapchain::begin(Extent framebuffer) {
  device_.throwIfLost();
  Commands& commands = *commands_[slot_];
  commands.wait();
  const std::optional<std::uint32_t> image = acquire(framebuffer);
  if (!image) return std::nullopt;
  return Frame{commands.begin(), *image, slot_, extent_};
}

std::optional<std::uint32_t> Swapchain::acquire(Extent framebuffer) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    if ((stale_ || framebuffer != framebuffer_) && !recreate(framebuffer)) return std::nullopt;
    if (!open_) open_ = acquireOnce();
    if (open_ || !stale_) return open_;
  }
  return std::nullopt;
}

// Absent with stale_ set: recreate and try again. Absent otherwise: no image within the time-out.
std::optional<std::uint32_t> Swapchain::acquireOnce() {
  return checked(device_, "asking the window for an image", [&]() -> std::optional<std::uint32_t> {
    try {
      const auto [result, image] =
          swapchain_.acquireNextImage(std::uint64_t(acquireTimeout.count()), *acquired_[slot_]);
      if (result == vk::Result::eTimeout || result == vk::Result::eNotReady) return std::nullopt;
      if (result == vk::Result::eSuboptimalKHR) stale_ = true;  // good for this frame, not for the next
      return image;
    } catch (const vk::OutOfDateKHRError&) {
      stale_ = true;
      return std::nullopt;
    }
  });
}

void Swapchain::beginRenderPass(const Frame& frame) {
  const vk::ClearValue clear{vk::ClearColorValue(darkGrey)};
  const vk::Extent2D size(std::uint32_t(frame.extent.width), std::uint32_t(frame.extent.height));
  const vk::RenderPassBeginInfo info(*renderPass_, *images_[frame.imageIndex].framebuffer, {{0, 0}, size},
                                     clear);
  frame.cmd.beginRenderPass(info, vk::SubpassContents::eInline);
}

void Swapchain::endRenderPass(const Frame& frame) {
  frame.cmd.endRenderPass();
}

void Swapchain::end(const Frame& frame, std::span<const Wait> waits, std::span<const vk::Semaphore> signals) {
  if (keepFrames_ && readable_) recordCopy(frame);
  std::vector<Wait> allWaits(waits.begin(), waits.end());
  allWaits.push_back({*acquired_[frame.slot]});
  std::vector<vk::Semaphore> allSignals(signals.begin(), signals.end());
  allSignals.push_back(*images_[frame.imageIndex].rendered);
  commands_[frame.slot]->submit(allWaits, allSignals);
  open_.reset();
  present(frame);
  slot_ = (slot_ + 1) % framesInFlight;
}

void Swapchain::present(const Frame& frame) {
  checked(device_, "presenting a frame", [&] {
    const vk::Semaphore rendered = *images_[frame.imageIndex].rendered;
    const vk::SwapchainKHR swapchain = *swapchain_;
    const vk::PresentInfoKHR info(rendered, swapchain, frame.imageIndex);
    try {
      const std::lock_guard lock(device_.present().mutex);
      if (device_.present().handle.presentKHR(info) == vk::Result::eSuboptimalKHR) stale_ = true;
    } catch (const vk::OutOfDateKHRError&) {
      stale_ = true;
    }
  });
}

// Copies the finished image into kept_, for screenshot(); the frame before may still be copying there.
void Swapchain::recordCopy(const Frame& frame) {
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  const vk::Image image = images_[frame.imageIndex].image;
  const auto toSource =
      layoutChange(image, vk::ImageLayout::ePresentSrcKHR, vk::ImageLayout::eTransferSrcOptimal,
                   Access::eColorAttachmentWrite, Access::eTransferRead);
  const vk::MemoryBarrier lastCopy(Access::eTransferWrite, Access::eTransferWrite);
  frame.cmd.pipelineBarrier(Stage::eColorAttachmentOutput | Stage::eTransfer, Stage::eTransfer, {}, lastCopy,
                            {}, toSource);
  const vk::Extent3D size(std::uint32_t(frame.extent.width), std::uint32_t(frame.extent.height), 1);
  const vk::BufferImageCopy region(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {}, size);
  frame.cmd.copyImageToBuffer(image, vk::ImageLayout::eTransferSrcOptimal, kept_.handle(), region);
  const auto toPresent =
      layoutChange(image, vk::ImageLayout::eTransferSrcOptimal, vk::ImageLayout::ePresentSrcKHR, {}, {});
  frame.cmd.pipelineBarrier(Stage::eTransfer, Stage::eBottomOfPipe, {}, {}, {}, toPresent);
  transferToHost(frame.cmd);
  keptFrame_ = true;
  keptExtent_ = frame.extent;
}

Image Swapchain::screenshot() {
  if (!keptFrame_)
    throw Error(ExitCode::failed, readable_ ? "no frame has been shown yet"
                                            : "this window system does not let its images be read");
  for (const auto& commands : commands_) commands->wait();
  Image image{keptExtent_.width, keptExtent_.height, 3, {}};
  const std::size_t count = std::size_t(keptExtent_.width) * std::size_t(keptExtent_.height);
  image.pixels.resize(count * 3);
  const bool blueFirst = format_.format == vk::Format::eB8G8R8A8Unorm;
  const auto* source = reinterpret_cast<const std::uint8_t*>(kept_.map());
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[i * 3 + c] = float(source[i * 4 + (blueFirst ? 2 - c : c)]) / 255.0f;
  return image;
}

Presenter::Handles Swapchain::handles() const {
  return {static_cast<VkInstance>(*device_.instance()),
          static_cast<VkPhysicalDevice>(*device_.physical()),
          static_cast<VkDevice>(*device_.handle()),
          static_cast<VkQueue>(*device_.graphics().handle),
          device_.graphics().family,
          reinterpret_cast<std::uint64_t>(static_cast<VkRenderPass>(*renderPass_)),
          imageCount()};
}

}  // namespace steradian::gpu
