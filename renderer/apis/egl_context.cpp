// SPDX-License-Identifier: MIT
// Devices as EGL_EXT_device_enumeration lists them, then Mesa's platform without a surface.
#include "renderer/apis/egl_context.hpp"

#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace steradian::apis {
namespace {

template <class Function>
Function eglFunction(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

bool isSoftware(EGLDeviceEXT device) {
  const auto query = eglFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  const char* extensions = query ? query(device, EGL_EXTENSIONS) : nullptr;
  return extensions && std::strstr(extensions, "EGL_MESA_device_software");
}

/// All displays that need no window system, the kind asked for first.
std::vector<EGLDisplay> displays(bool software) {
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  const auto query = eglFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  if (query && !query(EGLint(devices.size()), devices.data(), &count)) count = 0;
  std::stable_partition(devices.begin(), devices.begin() + count,
                        [&](EGLDeviceEXT device) { return isSoftware(device) == software; });
  std::vector<EGLDisplay> found;
  for (EGLint i = 0; i < count; ++i)
    found.push_back(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr));
  found.push_back(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return found;
}

std::string glString(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "unknown";
}

}  // namespace

EglContext::EglContext(bool software) {
  for (EGLDisplay display : displays(software))
    if (display != EGL_NO_DISPLAY && open(display)) return;
  throw std::runtime_error(
      "no EGL device has OpenGL 4.5 without a window; install its driver, e.g. libegl-mesa0 and "
      "libgl1-mesa-dri");
}

bool EglContext::open(EGLDisplay display) {
  if (!eglInitialize(display, nullptr, nullptr)) return false;
  constexpr EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   4,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   5,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
  display_ = display;
  context_ = eglBindAPI(EGL_OPENGL_API)
                 ? eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes)
                 : EGL_NO_CONTEXT;
  if (context_ != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
    return true;
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display, context_);
  eglTerminate(display);
  return false;
}

EglContext::~EglContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

void EglContext::use() const {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
}

std::string EglContext::runsOn() const {
  return glString(GL_RENDERER) + ", OpenGL " + glString(GL_VERSION);
}

bool EglContext::runsOnCpu() const {
  const std::string renderer = glString(GL_RENDERER);
  return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos;
}

}  // namespace steradian::apis
