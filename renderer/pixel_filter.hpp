// SPDX-License-Identifier: MIT
// Pixel reconstruction filters, sampled in proportion to themselves so that every sample has weight 1.
#pragma once
#include <vector>

namespace steradian {

/// Inverse CDF of the 4-term Blackman-Harris window (Harris 1978) over [-2, 2] pixels, at i / n for i = 0..n.
std::vector<double> blackmanHarrisInverseCdf(int n);

}  // namespace steradian
