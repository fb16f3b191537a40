// SPDX-License-Identifier: MIT
// The operating system's window: size, scale, title, dropped files and the wish to close.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/renderer.hpp"

struct GLFWwindow;

namespace steradian {

/// How large the user interface must be drawn.
struct UiScale {
  float units = 1.0f;          // window units per design pixel (1 = 96 dpi)
  float pixelsPerUnit = 1.0f;  // framebuffer pixels per window unit (1 on X11)
  bool operator==(const UiScale&) const = default;
};

/// A key that went down; as an event, because a quick tap may begin and end between two frames.
struct KeyPress {
  int key = 0;  // GLFW's key code: a position on the American keyboard
  bool control = false, shift = false, alt = false;
};

/// One window with no graphics API of its own. Main thread only.
class Window {
 public:
  /// Throws Error(noDevice) when there is no display, or no Vulkan loader to present with.
  Window(Extent size, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Handles pending events; waits up to `waitSeconds` for the first one.
  void poll(double waitSeconds);
  /// Ends a poll that waits. Any thread.
  static void wake();

  Extent framebuffer() const;  // pixels; 0 x 0 when minimised
  UiScale scale() const;       // of the monitor that the window is on
  bool focused() const { return focused_; }
  void setTitle(const std::string& title);

  /// True once after each attempt to close the window; the window stays open until the program ends.
  bool takeCloseRequest();
  /// Files dropped since the last call.
  std::vector<std::filesystem::path> takeDropped();

  /// Keys pressed since the last call; repeats of held keys are left out.
  std::vector<KeyPress> takeKeyPresses();

  std::vector<const char*> vulkanExtensions() const;
  GLFWwindow* handle() const { return window_; }

 private:
  void installCallbacks();

  GLFWwindow* window_ = nullptr;
  std::string title_;
  std::vector<std::filesystem::path> dropped_;
  std::vector<KeyPress> keys_;
  bool closeRequested_ = false;
  bool focused_ = true;
};

}  // namespace steradian
