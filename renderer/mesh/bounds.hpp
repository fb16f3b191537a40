// SPDX-License-Identifier: MIT
// Boxes in four lanes (x, y, z, -), as the builder of hierarchies needs them millions of times.
#pragma once
#include <bit>
#include <cstdint>
#include <limits>

#include <glm/glm.hpp>

namespace steradian {

using Float4 = float __attribute__((vector_size(16)));

inline Float4 least(Float4 a, Float4 b) {
  return a < b ? a : b;
}
inline Float4 most(Float4 a, Float4 b) {
  return a > b ? a : b;
}

struct Bounds {
  static constexpr float infinite = std::numeric_limits<float>::infinity();
  Float4 low = {infinite, infinite, infinite, infinite};
  Float4 high = {-infinite, -infinite, -infinite, -infinite};

  void add(Float4 point) {
    low = least(low, point);
    high = most(high, point);
  }
  void add(const Bounds& other) {
    low = least(low, other.low);
    high = most(high, other.high);
  }
  bool empty() const { return !(low[0] <= high[0]); }
  /// Half of the surface; of an empty box 0.
  float halfArea() const {
    const Float4 size = high - low;
    return empty() ? 0.0f : size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

}  // namespace steradian
