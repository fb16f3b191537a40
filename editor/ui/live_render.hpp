// SPDX-License-Identifier: MIT
// The viewport's renderer: follows the document, traces in slices, measures its error now and then.
#pragma once
#include <chrono>
#include <memory>
#include <optional>

#include "editor/document.hpp"
#include "editor/ui/messages.hpp"
#include "plugins/host/plugin_host.hpp"
#include "renderer/renderer.hpp"

namespace steradian::ui {

class LiveRender {
 public:
  LiveRender(std::shared_ptr<gpu::Device> device, std::shared_ptr<SceneCache> cache,
             const plugins::PluginHost& plugins, Messages& messages);

  /// What is to be shown from now on. A scene that the device cannot take is reported once; the last one
  /// stays.
  void show(const Snapshot& scene, const CameraView& view, Extent film);
  /// Adds samples for about `budgetMs`, up to `sampleLimit` (0 = no limit).
  void advance(double budgetMs, std::uint64_t sampleLimit);
  /// Nothing left to add under this limit.
  bool resting(std::uint64_t sampleLimit) const;

  std::optional<PickResult> pick(int x, int y);
  Renderer& renderer() { return renderer_; }
  const RenderStats& stats() const { return renderer_.stats(); }
  Extent film() const { return film_; }
  /// The sample count that stats().error was measured at.
  std::uint64_t measuredAt() const { return measuredAt_; }
  /// Wall time, frames included, since the picture started over; 0 = not known yet.
  double secondsPerSample() const;

 private:
  void showDisplay(const DisplaySettings& display);
  void keepPace();
  void measureWhenDue(bool last);

  Renderer renderer_;
  const plugins::PluginHost& plugins_;
  Messages& messages_;
  Snapshot scene_;
  CameraView view_;
  Extent film_;
  std::optional<DisplaySettings> display_;
  std::uint64_t measuredAt_ = 0, tailsAt_ = 0;
  bool measuringTails_ = false;
  double seconds_ = 0.0;  // of work on this picture
  std::chrono::steady_clock::time_point measuredTime_{}, steppedTime_{};
  bool lost_ = false;  // the device is gone: the document can still be saved
};

}  // namespace steradian::ui
