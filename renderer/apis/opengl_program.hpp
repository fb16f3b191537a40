// SPDX-License-Identifier: MIT
// The kernel's text through OpenGL's own compiler.
#pragma once
#include <cstdint>
#include <span>

namespace steradian::apis {

/// A linked compute program of the current context; `constants`: specialization constants by their id. Throws
/// std::runtime_error with the compiler's first line.
unsigned compiledTracer(std::span<const std::uint32_t> constants);

}  // namespace steradian::apis
