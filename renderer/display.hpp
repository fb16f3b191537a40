// SPDX-License-Identifier: MIT
// Resolved radiance -> what is seen: one text behind the viewport (drawn) and the saved PNG (computed).
#pragma once
#include <memory>
#include <vector>

#include "renderer/glsl_compiler.hpp"
#include "renderer/gpu/pass.hpp"
#include "renderer/renderer.hpp"
#include "shaders/gpu_types.h"

namespace steradian {

/// Factor before the tonemapper: stops, and for a physical exposure the luminance that ISO 100 film of this
/// EV saturates at, 1.2 * 2^EV100 (Lagarde & de Rousiers 2014, "Moving Frostbite to PBR", eq. 62).
float exposureScaleOf(const DisplaySettings& settings);

/// The stage's whole text with this tonemapper in it. Line numbers in messages are the tonemapper's own.
std::string displaySource(const Tonemapper& tonemapper, ShaderStage stage);

/// Compiled code and values; pipelines are made per render pass by pipeline().
class Display {
 public:
  explicit Display(const gpu::Device& device);

  /// Throws Error(plugin) with the compiler's lines; the old tonemapper stays.
  void setTonemapper(const Tonemapper& tonemapper);
  void setSettings(const DisplaySettings& settings) { settings_ = settings; }
  gpu::DisplayParams params(Extent film, PixelRect rect) const;
  std::unique_ptr<gpu::GraphicsPass> pipeline(gpu::TargetPass renderPass) const;
  /// What a window of the film's size would show, 3 channels as encoded. `resolved`: film.width * film.height
  /// vec4. Waits; on the compute queue alone, so that a still needs nothing that draws.
  Image picture(const gpu::Buffer& resolved, Extent film);
  /// Changes with every new tonemapper: pipelines of an older version are stale.
  int version() const { return version_; }

 private:
  const gpu::Device& device_;
  Tonemapper tonemapper_;
  DisplaySettings settings_;
  std::vector<std::uint32_t> spirv_;           // fragment
  std::unique_ptr<gpu::ComputePass> compute_;  // of this tonemapper, made when first needed
  int version_ = 0;
};

}  // namespace steradian
