// SPDX-License-Identifier: MIT
// An OpenGL 4.5 context without window or surface, made current on the calling thread.
#pragma once
#include <EGL/egl.h>

#include <string>

namespace steradian::apis {

class EglContext {
 public:
  /// The first device that has OpenGL 4.5; those that run on the CPU come first or last. Throws
  /// std::runtime_error: one line.
  explicit EglContext(bool software);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void use() const;
  std::string runsOn() const;  // "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 ..."
  bool runsOnCpu() const;

 private:
  bool open(EGLDisplay display);

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace steradian::apis
