// SPDX-License-Identifier: MIT
// How different two images are, the second being the reference.
#pragma once
#include <array>
#include <cstdint>

#include "renderer/image.hpp"

namespace steradian::cli {

/// Over the first three channels (a grey image counts as three equal ones), in double. Values that are not
/// finite in either image are counted and left out of every figure.
struct ImageDifference {
  std::array<double, 3> meanRatio{};  // mean(a) / mean(b) per channel; 1 when both are 0
  double mse = 0.0;                   // mean (a - b)^2
  double relMse = 0.0;                // mean (a - b)^2 / (b^2 + 0.01)
  double relRmse = 0.0;               // its square root
  double smape = 0.0;                 // mean 2 |a - b| / (|a| + |b|), 0 where both are 0; in [0, 2]
  double max = 0.0;                   // largest |a - b|
  std::uint64_t nan = 0, inf = 0;     // values, in both images together
};

/// Throws Error(badInput) when the sizes differ.
ImageDifference differenceOf(const Image& image, const Image& reference);

}  // namespace steradian::cli
