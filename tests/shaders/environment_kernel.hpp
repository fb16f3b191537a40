// SPDX-License-Identifier: MIT
#pragma once
#include "shaders/kernel_environment.comp.h"
#include "tests/shaders/kernel.hpp"

namespace steradian::kernel {

inline const Kernel environment{kernel_environment_spirv, "environment"};

}  // namespace steradian::kernel
