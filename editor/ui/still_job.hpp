// SPDX-License-Identifier: MIT
// A still rendered in slices between frames: the window goes on working while it runs.
#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "plugins/host/plugin_host.hpp"
#include "renderer/renderer.hpp"

namespace steradian::ui {

struct StillSettings {
  Extent size{1280, 720};
  bool byError = false;        // until the error target, else until `samples`
  int samples = 256;           // per pixel
  double errorPercent = 1.0;   // relative RMSE
  bool fromView = false;       // the editor's view instead of the scene's camera
  std::filesystem::path path;  // .exr or .png
};

/// Owns a renderer of its own; edits made meanwhile do not reach it.
class StillJob {
 public:
  /// Throws Error when the device cannot take the scene.
  StillJob(std::shared_ptr<gpu::Device> device, std::shared_ptr<SceneCache> cache, const Scene& scene,
           const CameraView& view, const Tonemapper& tonemapper, StillSettings settings);
  ~StillJob();

  /// Traces for about `budgetMs`. True when the picture is done.
  bool advance(double budgetMs);
  /// Writes what there is to settings().path. Throws Error(io | plugin); an older file stays then.
  void write(const plugins::PluginHost& plugins, const std::string& device);

  const StillSettings& settings() const { return settings_; }
  const RenderStats& stats() const;
  double fraction() const;  // 0..1
  double seconds() const;
  std::optional<double> remainingSeconds() const;

 private:
  bool goodEnough() const;
  void measure();

  StillSettings settings_;
  Renderer renderer_;
  std::uint32_t seed_;
  std::string sceneName_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::uint64_t measureAt_ = 2, measuredAt_ = 0;
};

}  // namespace steradian::ui
