// SPDX-License-Identifier: MIT
// Binned surface area heuristic (Wald, On fast construction of SAH-based bounding volume hierarchies, 2007).
#include "renderer/mesh/bvh_split.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>

namespace steradian {
namespace {

constexpr int binCount = 16;
constexpr std::size_t worthAThread = 1 << 16;
using Int4 = int __attribute__((vector_size(16)));

/// Maps a centre to its bin along each axis.
struct Grid {
  Float4 origin, scale;

  explicit Grid(const Bounds& centres) : origin(centres.low) {
    const Float4 size = centres.high - centres.low;
    for (int axis = 0; axis < 3; ++axis)
      scale[axis] = size[axis] > 0.0f ? binCount * 0.9999f / size[axis] : 0.0f;
    // An axis whose size overflows or vanishes is of no use.
    for (int axis = 0; axis < 3; ++axis)
      if (!(scale[axis] < Bounds::infinite)) scale[axis] = 0.0f;
    origin[3] = scale[3] = 0.0f;
  }
  Int4 binsOf(const BoxReference& r) const {
    Float4 centre = r.centre();
    centre[3] = 0.0f;
    return __builtin_convertvector((centre - origin) * scale, Int4);
  }
};

struct Bin {
  Bounds bounds;
  std::size_t count = 0;
  void add(const Bin& other) {
    bounds.add(other.bounds);
    count += other.count;
  }
};
using Bins = std::array<std::array<Bin, binCount>, 3>;

/// Sums `part` over pieces of the references on several threads, in any order: minima, maxima and counts do
/// not mind.
template <class Sum, class Part>
Sum summed(std::span<BoxReference> references, unsigned threads, const Part& part) {
  const std::size_t pieces = std::min<std::size_t>(threads, references.size() / worthAThread);
  if (pieces < 2) return part(references);
  const std::size_t half = references.size() / 2;
  auto other = std::async(std::launch::async,
                          [&] { return summed<Sum>(references.subspan(half), threads / 2, part); });
  Sum sum = summed<Sum>(references.first(half), threads - threads / 2, part);
  sum.add(other.get());
  return sum;
}

Bounds boundsOfCentres(std::span<BoxReference> references, unsigned threads) {
  return summed<Bounds>(references, threads, [](std::span<BoxReference> piece) {
    Bounds bounds;
    for (const BoxReference& r : piece) bounds.add(r.centre());
    return bounds;
  });
}

struct BinSum {
  Bins bins;
  void add(const BinSum& other) {
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < binCount; ++i) bins[axis][i].add(other.bins[axis][i]);
  }
};

Bins binned(std::span<BoxReference> references, const Grid& grid, unsigned threads) {
  return summed<BinSum>(references, threads,
                        [&](std::span<BoxReference> piece) {
                          BinSum sum;
                          for (const BoxReference& r : piece) {
                            const Int4 at = grid.binsOf(r);
                            for (int axis = 0; axis < 3; ++axis) {
                              Bin& bin = sum.bins[axis][at[axis]];
                              bin.bounds.low = least(bin.bounds.low, r.low);
                              bin.bounds.high = most(bin.bounds.high, r.high);
                              ++bin.count;
                            }
                          }
                          return sum;
                        })
      .bins;
}

struct Candidate {
  float cost = Bounds::infinite;
  int axis = -1, bin = 0;  // bins [0, bin) go left
  std::size_t count = 0;
  Bounds left, right;
};

/// `cost`: areas times counts, not yet divided by the parent's area.
void tryAxis(const std::array<Bin, binCount>& bins, int axis, Candidate& best) {
  std::array<Bin, binCount + 1> right;  // of the bins from i on
  for (int i = binCount - 1; i > 0; --i) {
    right[i] = right[i + 1];
    right[i].add(bins[i]);
  }
  Bin left;
  for (int i = 1; i < binCount; ++i) {
    left.add(bins[i - 1]);
    if (left.count == 0 || right[i].count == 0) continue;
    const float cost =
        left.bounds.halfArea() * float(left.count) + right[i].bounds.halfArea() * float(right[i].count);
    if (cost < best.cost) best = {cost, axis, i, left.count, left.bounds, right[i].bounds};
  }
}

Bounds boundsOf(std::span<const BoxReference> references) {
  Bounds bounds;
  for (const BoxReference& r : references) bounds.add(Bounds{r.low, r.high});
  return bounds;
}

// For sets that no plane separates, and where levels run short.
Split halved(std::span<BoxReference> references, const Bounds& centres) {
  const Float4 size = centres.high - centres.low;
  const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : (size[1] >= size[2] ? 1 : 2);
  const std::size_t half = references.size() / 2;
  std::nth_element(references.begin(), references.begin() + std::ptrdiff_t(half), references.end(),
                   [axis](const BoxReference& a, const BoxReference& b) {
                     const float x = a.centre()[axis], y = b.centre()[axis];
                     return x != y ? x < y : a.number() < b.number();
                   });
  return {half, boundsOf(references.first(half)), boundsOf(references.subspan(half))};
}

}  // namespace

std::optional<Split> splitReferences(std::span<BoxReference> references, const SplitCosts& costs, int levels,
                                     unsigned threads) {
  const std::size_t count = references.size();
  if (count < 2) return std::nullopt;
  const Bounds centres = boundsOfCentres(references, threads);
  const bool mustSplit = count > costs.mostInLeaf;
  const int needed = int(std::ceil(std::log2(double(count) / double(costs.mostInLeaf))));
  if (mustSplit && needed >= levels) return halved(references, centres);

  const Grid grid(centres);
  const Bins bins = binned(references, grid, threads);
  Candidate best;
  for (int axis = 0; axis < 3; ++axis) tryAxis(bins[axis], axis, best);
  if (best.axis < 0) return mustSplit ? std::optional(halved(references, centres)) : std::nullopt;
  Bounds all = best.left;
  all.add(best.right);
  const float area = std::max(all.halfArea(), std::numeric_limits<float>::min());
  if (!mustSplit && costs.leaf * float(count) <= costs.node + costs.leaf * best.cost / area)
    return std::nullopt;
  std::partition(references.begin(), references.end(),
                 [&](const BoxReference& r) { return grid.binsOf(r)[best.axis] < best.bin; });
  return Split{best.count, best.left, best.right};
}

}  // namespace steradian
