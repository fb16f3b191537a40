// SPDX-License-Identifier: MIT
// Pixel reconstruction filters, sampled in proportion to themselves so that every sample has weight 1.
#pragma once
#include <vector>

namespace steradian {

/// Inverse CDF of the 4-term Blackman-Harris window (Harris 1978) over [-2, 2] pixels, at i / n for i = 0..n.
std::vector<double> blackmanHarrisInverseCdf(int n);

/// The same for the box, 1 pixel wide: [-0.5, 0.5].
std::vector<double> boxInverseCdf(int n);

}  // namespace steradian
