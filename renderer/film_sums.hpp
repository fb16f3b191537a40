// SPDX-License-Identifier: MIT
// What a film has accumulated, read back without loss.
#pragma once
#include <array>
#include <cstdint>

#include "renderer/renderer.hpp"

namespace steradian {

/// The compensated sums of half A (even sample indices) and B (odd ones; empty without the error meter).
struct FilmSums {
  std::array<Image, 2> sum, carry;   // 3 channels; the value is sum - carry
  std::uint64_t begin = 0, end = 0;  // sample indices that every pixel holds
  std::uint64_t endAhead = 0;  // ... and that the first rowsAhead rows hold already; == end between passes
  int rowsAhead = 0;
  bool errorMeter = false;

  /// Samples of half 0 (A) or 1 (B) in a row of pixels.
  std::uint64_t count(int half, int row) const;
};

/// Mean radiance of each pixel, rounded once: what merged parts of the same samples give.
Image meanOf(const FilmSums& sums);

/// How many of the samples [begin, end) half 0 (A, the even ones) or 1 (B) holds; all are A's without the
/// meter.
std::uint64_t samplesOfHalf(std::uint64_t begin, std::uint64_t end, int half, bool errorMeter);

/// Which pixels carry the error. d^2 between the half-buffers of one pixel is a poor estimate of its own
/// error, but a share of the image's total is not.
ErrorTails tailsOf(const FilmSums& sums);

/// The smallest share of the pixels that tailsOf looks at.
inline constexpr double kTailPixels = 0.001;

}  // namespace steradian
