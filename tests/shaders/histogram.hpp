// SPDX-License-Identifier: MIT
// Whether samples of a light fill it as evenly as they should.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/shaders/kernel.hpp"
#include "tests/shaders/oracle.hpp"

namespace steradian::kernel {

inline constexpr std::size_t manySamples = 1'000'000;
inline const double sidak = 1 - std::pow(0.99, 1.0 / 13);  // thirteen histograms of lights

/// P of the chi-square test of samples over 101 x 202 cells of the unit square, expected shares given; cells
/// that expect fewer than 5 are pooled.
template <class Sample, class UnitOf>
double histogramP(const std::vector<Sample>& samples, const UnitOf& unitOf,
                  const std::function<double(int, int)>& share) {
  constexpr int rows = 101, columns = 202;
  std::vector<double> seen(rows * columns, 0.0);
  for (const Sample& s : samples) {
    const glm::dvec3 at = unitOf(s);
    const int r = std::clamp(int(at.x * rows), 0, rows - 1),
              c = std::clamp(int(at.y * columns), 0, columns - 1);
    seen[std::size_t(r * columns + c)] += 1;
  }
  double statistic = 0, degrees = -1, pooledSeen = 0, pooledExpected = 0;
  const auto count = [&](double observed, double expected) {
    statistic += (observed - expected) * (observed - expected) / expected;
    degrees += 1;
  };
  for (int i = 0; i < rows * columns; ++i) {
    const double expected = share(i / columns, i % columns) * double(samples.size()),
                 observed = seen[std::size_t(i)];
    if (expected >= 5) {
      count(observed, expected);
    } else {
      pooledSeen += observed;
      pooledExpected += expected;
    }
  }
  if (pooledExpected >= 5) count(pooledSeen, pooledExpected);
  return oracle::chiSquareP(statistic, degrees);
}

inline double evenShare(int, int) {
  return 1.0 / (101 * 202);
}

inline void expectEven(double p, double significance, const std::string& what) {
  EXPECT_GT(p, significance) << what;
  measuredAtLeast("least p of chi-square", p, significance);
}

}  // namespace steradian::kernel
