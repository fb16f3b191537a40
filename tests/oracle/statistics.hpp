// SPDX-License-Identifier: MIT
// Do two noisy pictures show the same truth? Welch's t-test for every pixel, and a look at all p-values at
// once.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "renderer/scene/image.hpp"
#include "tests/oracle/oracle.hpp"

namespace steradian::oracle {

/// A mean of independent values, the variance of that mean, and the degrees of freedom that the variance was
/// measured with (n - 1 for n values).
struct Measured {
  double mean = 0.0, varianceOfMean = 0.0, degrees = 1.0;
};

/// Two-sided p-value of Student's t with `degrees` > 0 degrees of freedom.
double studentTwoSided(double t, double degrees);
/// Two-sided p-value that both measure the same mean (Welch 1947). Spread below a float's rounding is taken
/// to be that rounding, 1e-6 of the value.
double welch(const Measured& a, const Measured& b);
/// What one of `tests` p-values may fall to when all should stay above `overall` together (Sidak 1967).
double sidak(double overall, std::size_t tests);
/// p-value that the values are even over [0, 1] (Kolmogorov-Smirnov; Stephens 1970 for few values).
double kolmogorovSmirnov(std::vector<double> values);

/// Independent renders of one scene as independent samples. At least 2 images of one size, 3 channels.
Estimate fromImages(const std::vector<Image>& images);

struct Agreement {
  std::size_t tests = 0;    // tiles times channels
  double smallest = 1.0;    // p-value
  double limit = 0.0;       // Sidak's for 1e-4 over all
  double passing = 1.0;     // share of the tiles with no p-value below Sidak's for 0.01 over all
  double uniformity = 1.0;  // p-value that the random tiles' p-values are even; 1 when too few are random
  double meanRatio = 1.0;   // of the picture's sums, first / second
  std::size_t random = 0;   // tiles whose noise is above rounding
  std::array<int, 10> histogram{};  // of the random tiles' p-values
  std::string worst;                // the tile of `smallest`

  bool holds() const { return smallest >= limit && uniformity > 1e-4; }
};

/// Every tile and channel against `limit`; the evenness on the green channel alone, as the channels of a
/// pixel are not independent. Pixels are averaged over square tiles: n x n pixels show differences n times
/// smaller.
Agreement compare(const Estimate& ours, const Estimate& oracle, int tile = 1);

/// A line of figures and a bar for each tenth of the p-values.
std::string report(const Agreement& agreement);

}  // namespace steradian::oracle
