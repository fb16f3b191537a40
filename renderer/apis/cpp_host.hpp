// SPDX-License-Identifier: MIT
// The kernel as C++ through GLM: no device, no driver, all hardware threads.
#pragma once
#include <memory>

#include "renderer/apis/kernel.hpp"

namespace steradian::apis {

/// `input` must outlive it.
std::unique_ptr<KernelHost> makeCppHost(const KernelInput& input);

}  // namespace steradian::apis
