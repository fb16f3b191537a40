// SPDX-License-Identifier: MIT
// The kernel as an OpenGL 4.5 compute program, without a window: through EGL, in a module of its own.
#pragma once
#include <memory>

#include "renderer/apis/kernel.hpp"

namespace steradian::apis {

/// `software`: on a driver that runs on the CPU, if there is one; else on a GPU, if there is one. Throws
/// Error(noDevice): one line that says what is missing.
std::unique_ptr<KernelHost> makeOpenGlHost(const KernelInput& input, bool software);

}  // namespace steradian::apis
