// SPDX-License-Identifier: MIT
#include "renderer/presenter.hpp"

#include <array>

#include "renderer/gpu/barriers.hpp"
#include "renderer/gpu/commands.hpp"
#include "renderer/gpu/swapchain.hpp"
#include "renderer/renderer_impl.hpp"

namespace steradian {

using namespace gpu;

namespace {

// A frame in flight: its picture, and the compute submission that fills it.
struct Slot {
  explicit Slot(const Device& device)
      : commands(device, QueueKind::compute), resolved(makeSemaphore(device)) {}
  ResolvedPicture picture;
  Commands commands;
  Semaphore resolved;
};

}  // namespace

struct Presenter::Impl {
  Impl(std::shared_ptr<Device> opened, Extent framebuffer, PresentMode mode)
      : device(std::move(opened)), swapchain(*device, framebuffer, mode) {
    for (auto& slot : slots) slot = std::make_unique<Slot>(*device);
  }

  // Compute queue: film -> picture, handed to the graphics queue.
  void resolve(Renderer::Impl& renderer, Slot& slot) {
    slot.commands.wait();
    slot.picture.prepare(*device, renderer.shownFilm());
    const std::array signals{*slot.resolved};
    slot.commands.submit(
        [&](const auto& cmd) {
          computeToCompute(cmd);
          slot.picture.record(cmd, renderer.resolve, renderer.metered());
          release(cmd, slot.picture.buffer(), device->compute().family, device->graphics().family);
        },
        {}, signals);
  }

  void draw(Renderer::Impl& renderer, const Slot& slot, const Frame& frame, PixelRect viewport) {
    if (renderer.display.version() != displayVersion) {
      displayPass = renderer.display.pipeline(swapchain.renderPass());
      displayVersion = renderer.display.version();
    }
    const DisplayParams params = renderer.display.params(slot.picture.extent(), viewport);
    displayPass->draw(frame.cmd, slot.picture.displaying(), params, viewport);
  }

  std::shared_ptr<Device> device;
  std::array<std::unique_ptr<Slot>, Swapchain::framesInFlight> slots;
  std::unique_ptr<GraphicsPass> displayPass;
  int displayVersion = -1;
  Swapchain swapchain;  // last: waits for its frames before the slots die
};

namespace {

PixelRect clipped(PixelRect r, Extent to) {
  const int x = std::clamp(r.x, 0, to.width), y = std::clamp(r.y, 0, to.height);
  return {x, y, std::clamp(r.x + r.width, x, to.width) - x, std::clamp(r.y + r.height, y, to.height) - y};
}

}  // namespace

Presenter::Presenter(std::shared_ptr<Device> device, Extent framebuffer, PresentMode mode)
    : impl_(std::make_unique<Impl>(std::move(device), framebuffer, mode)) {}
Presenter::~Presenter() = default;

bool Presenter::present(Renderer& renderer, Extent framebuffer, PixelRect viewport,
                        const std::function<void(void*)>& overlay) {
  Impl& p = *impl_;
  Renderer::Impl& r = *renderer.impl_;
  const auto frame = p.swapchain.begin(framebuffer);
  if (!frame) return false;
  Slot& slot = *p.slots[frame->slot];
  const PixelRect rect = clipped(viewport, frame->extent);
  const bool picture = r.film && rect.width > 0 && rect.height > 0;
  std::vector<Wait> waits;
  if (picture) {
    if (!r.showPreview && !r.stats.compiling) r.currentFilm();
    p.resolve(r, slot);
    waits.push_back({*slot.resolved, frameReadsPicture});
    acquire(frame->cmd, slot.picture.buffer(), p.device->compute().family, p.device->graphics().family);
  }
  p.swapchain.beginRenderPass(*frame);
  if (picture) p.draw(r, slot, *frame, rect);
  if (overlay) overlay(frame->native());
  p.swapchain.endRenderPass(*frame);
  p.swapchain.end(*frame, waits);
  return true;
}

void Presenter::setPresentMode(PresentMode mode) {
  impl_->swapchain.setMode(mode);
}
std::vector<PresentMode> Presenter::availableModes() const {
  return impl_->swapchain.availableModes();
}

Presenter::Handles Presenter::handles() const {
  return impl_->swapchain.handles();
}
Image Presenter::screenshot() {
  return impl_->swapchain.screenshot();
}

}  // namespace steradian
