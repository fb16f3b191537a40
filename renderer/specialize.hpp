// SPDX-License-Identifier: MIT
// SPIR-V with its specialization constants settled before a driver sees it.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/gpu/pass.hpp"

namespace steradian {

/// `spirv` with `constants` folded in and all code removed that they make unreachable: some drivers inline
/// every function of a module before they look at its constants. Only control flow is touched, never
/// arithmetic, so results keep their bits. Any thread. Empty when the module cannot be rewritten.
std::vector<std::uint32_t> specialized(std::span<const std::uint32_t> spirv,
                                       std::span<const gpu::Specialization> constants);

}  // namespace steradian
