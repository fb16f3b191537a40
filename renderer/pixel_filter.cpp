// SPDX-License-Identifier: MIT
#include "renderer/pixel_filter.hpp"

#include <cmath>
#include <numbers>

namespace steradian {
namespace {

// Integral of the window from 0 to t, t in [0, 1], normalized to 1.
double windowCdf(double t) {
  const double a[] = {0.35875, 0.48829, 0.14128, 0.01168};
  const double w = 2.0 * std::numbers::pi;
  const double integral = a[0] * t - a[1] * std::sin(w * t) / w + a[2] * std::sin(2 * w * t) / (2 * w) -
                          a[3] * std::sin(3 * w * t) / (3 * w);
  return integral / a[0];
}

double invert(double target) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (windowCdf(middle) < target ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

std::vector<double> boxInverseCdf(int n) {
  std::vector<double> table(n + 1);
  for (int i = 0; i <= n; ++i) table[i] = double(i) / n - 0.5;
  return table;
}

std::vector<double> blackmanHarrisInverseCdf(int n) {
  std::vector<double> table(n + 1);
  for (int i = 0; i <= n; ++i) table[i] = 4.0 * invert(double(i) / n) - 2.0;
  return table;
}

}  // namespace steradian
