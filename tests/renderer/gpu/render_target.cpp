// SPDX-License-Identifier: MIT
// The offscreen picture and its read-back.
#include "tests/renderer/gpu/render_target.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "renderer/gpu/barriers.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::gpu {
namespace {

constexpr vk::Format format = vk::Format::eR32G32B32A32Sfloat;
constexpr std::size_t channels = 4;  // on the device
constexpr vk::ImageSubresourceRange wholeImage{vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1};

using Stage = vk::PipelineStageFlagBits;
using Access = vk::AccessFlagBits;

// The picture is copied by transfer after the pass; the dependency below also moves it to that layout.
vk::raii::RenderPass makeRenderPass(const Device& device) {
  vk::AttachmentDescription colour;
  colour.format = format;
  colour.loadOp = vk::AttachmentLoadOp::eClear;
  colour.storeOp = vk::AttachmentStoreOp::eStore;
  colour.finalLayout = vk::ImageLayout::eTransferSrcOptimal;
  const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
  vk::SubpassDescription subpass;
  subpass.setColorAttachments(reference);
  const std::array dependencies = {
      vk::SubpassDependency(VK_SUBPASS_EXTERNAL, 0, Stage::eTransfer, Stage::eColorAttachmentOutput,
                            Access::eTransferRead, Access::eColorAttachmentWrite),
      vk::SubpassDependency(0, VK_SUBPASS_EXTERNAL, Stage::eColorAttachmentOutput, Stage::eTransfer,
                            Access::eColorAttachmentWrite, Access::eTransferRead)};
  const vk::RenderPassCreateInfo info({}, colour, subpass, dependencies);
  return checked(device, "creating a render pass",
                 [&] { return vk::raii::RenderPass(device.handle(), info); });
}

}  // namespace

RenderTarget::RenderTarget(const Device& device, Extent extent)
    : device_(device), extent_(extent), renderPass_(makeRenderPass(device)) {
  const std::uint32_t limit =
      std::min(device.limits().maxImageDimension2D,
               std::min(device.limits().maxFramebufferWidth, device.limits().maxFramebufferHeight));
  if (extent.width < 1 || extent.height < 1 || std::uint32_t(extent.width) > limit ||
      std::uint32_t(extent.height) > limit)
    throw Error(ExitCode::noDevice, device.description().name + ": a picture of " +
                                        std::to_string(extent.width) + "x" + std::to_string(extent.height) +
                                        " cannot be drawn, the device allows 1 to " + std::to_string(limit) +
                                        " pixels each way");
  createImage();
  createFramebuffer();
  const std::size_t bytes = std::size_t(extent.width) * std::size_t(extent.height) * channels * sizeof(float);
  pixels_ = Buffer(device, BufferKind::readback, bytes, "picture, read-back");
}

void RenderTarget::createImage() {
  vk::ImageCreateInfo info({}, vk::ImageType::e2D, format,
                           {std::uint32_t(extent_.width), std::uint32_t(extent_.height), 1}, 1, 1);
  info.usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc;
  checked(device_, "creating the picture", [&] {
    image_ = vk::raii::Image(device_.handle(), info);
    const vk::MemoryRequirements needs = image_.getMemoryRequirements();
    int type = device_.memoryType(needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal);
    if (type < 0) type = device_.memoryType(needs.memoryTypeBits, {});
    memory_ =
        vk::raii::DeviceMemory(device_.handle(), vk::MemoryAllocateInfo(needs.size, std::uint32_t(type)));
    image_.bindMemory(*memory_, 0);
  });
}

void RenderTarget::createFramebuffer() {
  const vk::ImageViewCreateInfo viewInfo({}, *image_, vk::ImageViewType::e2D, format, {}, wholeImage);
  checked(device_, "creating a framebuffer", [&] {
    view_ = vk::raii::ImageView(device_.handle(), viewInfo);
    const vk::ImageView attachment = *view_;
    const vk::FramebufferCreateInfo info({}, *renderPass_, attachment, std::uint32_t(extent_.width),
                                         std::uint32_t(extent_.height), 1);
    framebuffer_ = vk::raii::Framebuffer(device_.handle(), info);
  });
}

Image RenderTarget::render(const Record& draw, const Record& before, const Record& after) {
  const vk::Extent2D size(std::uint32_t(extent_.width), std::uint32_t(extent_.height));
  device_.run(QueueKind::graphics, [&](const vk::raii::CommandBuffer& cmd) {
    if (before) before(cmd);
    const vk::ClearValue black(vk::ClearColorValue(std::array<float, 4>{0.0f, 0.0f, 0.0f, 1.0f}));
    const vk::RenderPassBeginInfo begin(*renderPass_, *framebuffer_, {{0, 0}, size}, black);
    cmd.beginRenderPass(begin, vk::SubpassContents::eInline);
    draw(cmd);
    cmd.endRenderPass();
    if (after) after(cmd);
    const vk::BufferImageCopy region(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                     {size.width, size.height, 1});
    cmd.copyImageToBuffer(*image_, vk::ImageLayout::eTransferSrcOptimal, pixels_.handle(), region);
    transferToHost(cmd);
  });
  return toImage();
}

Image RenderTarget::toImage() const {
  Image image{extent_.width, extent_.height, 3, {}};
  const std::size_t count = std::size_t(extent_.width) * std::size_t(extent_.height);
  image.pixels.resize(count * 3);
  const std::byte* source = pixels_.map();
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(&image.pixels[i * 3], source + i * channels * sizeof(float), 3 * sizeof(float));
  return image;
}

}  // namespace steradian::gpu
