// SPDX-License-Identifier: MIT
// The SPIR-V modules and texts that the build embeds.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace steradian {

std::span<const std::uint32_t> pathTraceSpirv();
std::span<const std::uint32_t> resolveSpirv();
std::span<const std::uint32_t> levelSpirv();
std::span<const std::uint32_t> meterSpirv();
std::span<const std::uint32_t> pickSpirv();
std::span<const std::uint32_t> aovSpirv();
std::span<const std::uint32_t> castRaysSpirv();
std::span<const std::uint32_t> displayVertexSpirv();
/// Texts that a tonemapper completes at run time: the types, what both stages share, and each stage's main.
std::string_view gpuTypesText();
std::string_view displayText();
std::string_view displayFragmentText();
std::string_view displayComputeText();

}  // namespace steradian
