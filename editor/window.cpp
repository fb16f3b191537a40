// SPDX-License-Identifier: MIT
// GLFW behind the Window class.
#include "editor/window.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "renderer/scene/error.hpp"

namespace steradian {

namespace {

std::string glfwReason() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

Window& windowOf(GLFWwindow* handle) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

/// As large as asked for in design pixels, but never larger than what the monitor leaves free.
Extent fitToMonitor(Extent size) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (!monitor) return size;
  float scale = 1.0f;
  glfwGetMonitorContentScale(monitor, &scale, nullptr);
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  if (width <= 0 || height <= 0) return size;
  return {std::min(int(float(size.width) * scale), width), std::min(int(float(size.height) * scale), height)};
}

}  // namespace

Window::Window(Extent size, const std::string& title) : title_(title) {
  glfwInitHint(GLFW_JOYSTICK_HAT_BUTTONS, GLFW_FALSE);
  if (!glfwInit()) {
    throw Error(ExitCode::noDevice, "No display to open a window on (" + glfwReason() +
                                        "). Set DISPLAY, or use `steradian render`, which needs none.");
  }
  if (!glfwVulkanSupported()) {
    glfwTerminate();
    throw Error(
        ExitCode::noDevice,
        "No Vulkan loader or driver found for the window. Install libvulkan1 and mesa-vulkan-drivers.");
  }
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "steradian");
  const Extent fitted = fitToMonitor(size);
  window_ = glfwCreateWindow(fitted.width, fitted.height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string reason = glfwReason();
    glfwTerminate();
    throw Error(ExitCode::noDevice, "The window could not be opened (" + reason + ").");
  }
  const Extent least = fitToMonitor({640, 400});
  glfwSetWindowSizeLimits(window_, least.width, least.height, GLFW_DONT_CARE, GLFW_DONT_CARE);
  installCallbacks();
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::installCallbacks() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* handle) {
    glfwSetWindowShouldClose(handle, GLFW_FALSE);  // the document may have unsaved changes: ask first
    windowOf(handle).closeRequested_ = true;
  });
  glfwSetDropCallback(window_, [](GLFWwindow* handle, int count, const char** paths) {
    for (int i = 0; i < count; ++i) windowOf(handle).dropped_.emplace_back(paths[i]);
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* handle, int key, int, int action, int mods) {
    if (action == GLFW_PRESS)
      windowOf(handle).keys_.push_back(
          {key, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_ALT) != 0});
  });
  glfwSetWindowFocusCallback(
      window_, [](GLFWwindow* handle, int focused) { windowOf(handle).focused_ = focused == GLFW_TRUE; });
}

void Window::poll(double waitSeconds) {
  if (waitSeconds > 0.0)
    glfwWaitEventsTimeout(waitSeconds);
  else
    glfwPollEvents();
}

void Window::wake() {
  glfwPostEmptyEvent();
}

Extent Window::framebuffer() const {
  Extent size;
  glfwGetFramebufferSize(window_, &size.width, &size.height);
  if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) return {};
  return size;
}

UiScale Window::scale() const {
  float x = 1.0f, y = 1.0f;
  glfwGetWindowContentScale(window_, &x, &y);
  int units = 0, pixels = 0, unused = 0;
  glfwGetWindowSize(window_, &units, &unused);
  glfwGetFramebufferSize(window_, &pixels, &unused);
  const float pixelsPerUnit = units > 0 && pixels > 0 ? float(pixels) / float(units) : 1.0f;
  return {std::clamp(std::max(x, y), 0.5f, 4.0f) / pixelsPerUnit, pixelsPerUnit};
}

void Window::setTitle(const std::string& title) {
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(window_, title.c_str());
}

bool Window::takeCloseRequest() {
  return std::exchange(closeRequested_, false);
}

std::vector<std::filesystem::path> Window::takeDropped() {
  return std::exchange(dropped_, {});
}

std::vector<KeyPress> Window::takeKeyPresses() {
  return std::exchange(keys_, {});
}

std::vector<const char*> Window::vulkanExtensions() const {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  return {names, names + count};
}

}  // namespace steradian
