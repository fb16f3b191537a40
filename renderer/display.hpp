// SPDX-License-Identifier: MIT
// Resolved radiance -> what is seen: the one pass behind the viewport and the saved PNG.
#pragma once
#include <memory>
#include <vector>

#include "renderer/gpu/pass.hpp"
#include "renderer/renderer.hpp"
#include "shaders/gpu_types.h"

namespace steradian {

/// The fragment shader's text with this tonemapper in it. Line numbers in messages are the tonemapper's own.
std::string displaySource(const Tonemapper& tonemapper);

/// Compiled code and values; pipelines are made per render pass by pipeline().
class Display {
 public:
  explicit Display(const gpu::Device& device);

  /// Throws Error(plugin) with the compiler's lines; the old tonemapper stays.
  void setTonemapper(const Tonemapper& tonemapper);
  void setSettings(const DisplaySettings& settings) { settings_ = settings; }
  gpu::DisplayParams params(Extent film, PixelRect rect) const;
  std::unique_ptr<gpu::GraphicsPass> pipeline(gpu::TargetPass renderPass) const;
  /// Changes with every new tonemapper: pipelines of an older version are stale.
  int version() const { return version_; }

 private:
  const gpu::Device& device_;
  Tonemapper tonemapper_;
  DisplaySettings settings_;
  std::vector<std::uint32_t> spirv_;
  int version_ = 0;
};

}  // namespace steradian
