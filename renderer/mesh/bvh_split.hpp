// SPDX-License-Identifier: MIT
// Where a set of boxes is best cut in two: what the hierarchies over triangles and over instances share.
#pragma once
#include <optional>
#include <span>

#include "renderer/mesh/bounds.hpp"

namespace steradian {

/// A box with the number of what it holds.
struct BoxReference {
  Float4 low, high;  // last lane of `low`: the number's bits; of `high`: 0

  BoxReference() = default;
  BoxReference(const Bounds& bounds, std::uint32_t number) : low(bounds.low), high(bounds.high) {
    low[3] = std::bit_cast<float>(number);
    high[3] = 0.0f;
  }
  std::uint32_t number() const { return std::bit_cast<std::uint32_t>(low[3]); }
  Float4 centre() const { return low + high; }  // twice
};

struct SplitCosts {
  float node = 1.0f;  // of testing two boxes
  float leaf = 1.0f;  // of testing what one reference holds
  std::size_t mostInLeaf = 4;
};

/// Sorts the references so that the first `count` go left, and tells their bounds.
struct Split {
  std::size_t count = 0;
  Bounds left, right;
};

/// The cheapest of 16 planes per axis between the centres; nothing when a leaf is cheaper. `levels`: how many
/// more levels there may be; when they run short the set is halved. `threads`: that may share the counting.
/// The result depends on the order of the references alone.
std::optional<Split> splitReferences(std::span<BoxReference> references, const SplitCosts& costs, int levels,
                                     unsigned threads);

}  // namespace steradian
