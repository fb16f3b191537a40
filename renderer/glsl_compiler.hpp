// SPDX-License-Identifier: MIT
// GLSL text -> SPIR-V at run time, for what is only known then: tonemappers.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace steradian {

enum class ShaderStage { compute, fragment };

/// Thread-safe. Throws Error(plugin): `name`, then the compiler's lines.
std::vector<std::uint32_t> compileGlsl(std::string_view source, ShaderStage stage, const std::string& name);

}  // namespace steradian
