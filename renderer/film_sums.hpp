// SPDX-License-Identifier: MIT
// What a film has accumulated, read back without loss.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "renderer/renderer.hpp"

namespace steradian {

/// A sum of radiance in units of its film: high + middle / FILM_BASE + low / FILM_BASE^2 (gpu_types.h).
struct FilmSum {
  std::int32_t low = 0, middle = 0, high = 0;
};

/// The sums of half A (even sample indices) and B (odd ones; 0 without the error meter).
struct FilmSums {
  int width = 0, height = 0;
  std::array<std::vector<FilmSum>, 2> sums;  // 3 channels per pixel
  double unit = 1.0;                         // radiance, a power of two
  std::uint64_t begin = 0, end = 0;          // sample indices that every pixel holds
  std::uint64_t endAhead = 0;  // ... and that the first rowsAhead rows hold already; == end between passes
  int rowsAhead = 0;
  bool errorMeter = false;

  /// Samples of half 0 (A) or 1 (B) in a row of pixels.
  std::uint64_t count(int half, int row) const;
  /// One value of a half, rounded once. `at` counts channels of pixels.
  double radiance(int half, std::size_t at) const;
  /// The same as three doubles whose sum is exact.
  std::array<double, 3> terms(int half, std::size_t at) const;
  /// Those of both halves together, rounded once.
  double radiance(std::size_t at) const;
  /// Whether either half has reached the end of what a film can hold.
  bool full(std::size_t at) const;
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
