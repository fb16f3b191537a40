// SPDX-License-Identifier: MIT
// ImGui on GLFW and Vulkan: set-up, fonts, drawing; the only editor file whose .cpp names Vulkan.
#pragma once
#include <cstdint>
#include <memory>

#include "editor/window.hpp"
#include "renderer/presenter.hpp"

namespace steradian::ui {

/// A surface of `window` for openDevice(); `window` must outlive the device.
SurfaceSource makeSurface(const Window& window);

/// Owns the ImGui context and its device objects. Destroy before the device and the window.
class ImguiVulkan {
 public:
  /// Throws Error(noDevice) when a device object cannot be made.
  ImguiVulkan(const Window& window, const Presenter::Handles& handles);
  ~ImguiVulkan();
  ImguiVulkan(const ImguiVulkan&) = delete;
  ImguiVulkan& operator=(const ImguiVulkan&) = delete;

  /// Fonts and sizes for the monitor; waits for the device when the scale really changed, and says so.
  /// Not between beginFrame() and endFrame().
  bool setScale(UiScale scale);
  void beginFrame();
  /// Closes the ImGui frame; afterwards draw() may be called any number of times.
  void endFrame();
  void draw(void* vkCommandBuffer);

 private:
  void uploadFonts();

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace steradian::ui
