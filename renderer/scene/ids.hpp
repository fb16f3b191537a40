// SPDX-License-Identifier: MIT
// Stable identities of scene entities: never indices, never reused within a scene.
#pragma once
#include <cstdint>
#include <functional>

namespace steradian {

/// One id space for objects and materials; `none` means "absent".
enum class Id : std::uint32_t { none = 0 };

}  // namespace steradian
