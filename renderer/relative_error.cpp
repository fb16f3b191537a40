// SPDX-License-Identifier: MIT
#include "renderer/relative_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace steradian {

namespace {

/// Of the light in the up to 8 pixels around (x, y), from the fourth roots of all.
double levelAround(Extent extent, const std::vector<double>& roots, int x, int y, int channel) {
  const auto at = [&](int u, int v) { return roots[(std::size_t(v) * extent.width + u) * 3 + channel]; };
  double sum = 0.0;
  int around = 0;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, extent.height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, extent.width - 1); ++u)
      if (u != x || v != y) sum += at(u, v), ++around;
  const double root = around > 0 ? sum / around : at(x, y);
  return root * root * root * root;
}

}  // namespace

double meanRelativeSquare(Extent extent, std::span<const double> means, std::span<const double> variances) {
  std::vector<double> roots(means.size());
  std::ranges::transform(means, roots.begin(),
                         [](double mean) { return std::pow(std::max(mean, 0.0), 0.25); });
  double sum = 0.0;
  for (std::size_t i = 0; i < means.size(); ++i) {
    const int pixel = int(i / 3);
    const double level = levelAround(extent, roots, pixel % extent.width, pixel / extent.width, int(i % 3));
    const double deviation = std::sqrt(variances[i]);
    const double light = std::clamp(level, means[i] - deviation, means[i] + deviation);
    sum += variances[i] / (light * light + kRelativeFloor);
  }
  return sum / double(means.size());
}

}  // namespace steradian
