// SPDX-License-Identifier: MIT
// Whether drawn directions have the density that they should have.
#pragma once
#include <functional>

#include "tests/shaders/bsdf_rows.hpp"

namespace steradian::kernel {

using Density = std::function<oracle::Real(oracle::Vec)>;  // per steradian
struct Band {
  double low = 0.0, high = 1.0;  // of cosines
};

/// p-value of the hypothesis that `drawn` (one per `stride` rows, directions in xyz) has this density over a
/// band; what lies beside it falls into one bin. 101 x 202 bins, those that expect fewer than 5 pooled.
inline double chiSquare(const Rows& drawn, std::size_t stride, const Density& density, Band band = {}) {
  constexpr int rings = 101, sectors = 202;
  std::vector<double> seen(rings * sectors + 1, 0.0), expected(rings * sectors + 1, 0.0);
  const std::size_t count = drawn.size() / stride;
  const double height = band.high - band.low;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec4 d = drawn[i * stride];
    const double turn = std::atan2(double(d.y), double(d.x)) / (2 * M_PI);
    const int ring = std::min(rings - 1, int((double(d.z) - band.low) / height * rings));
    const int sector = std::min(sectors - 1, int((turn < 0 ? turn + 1 : turn) * sectors));
    const bool within = d.z > band.low && d.z <= band.high;
    seen[within ? std::size_t(ring * sectors + sector) : rings * sectors] += 1;
  }
  const oracle::Gauss<8> gauss = oracle::gauss8();
  double above = 0;
  for (int bin = 0; bin < rings * sectors; ++bin) {
    double share = 0;
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t k = 0; k < 8; ++k) {
        const double cosine = band.low + (bin / sectors + gauss.x[i]) / rings * height;
        const double turn = 2 * M_PI * (bin % sectors + gauss.x[k]) / sectors;
        share += gauss.w[i] * gauss.w[k] * double(density(oracle::Vec(direction(cosine, turn))));
      }
    expected[std::size_t(bin)] = share * 2 * M_PI * height / (rings * sectors) * double(count);
    above += expected[std::size_t(bin)];
  }
  expected.back() = std::max(0.0, double(count) - above);
  double statistic = 0, pooledSeen = 0, pooledExpected = 0;
  int bins = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (expected[i] < 5) {
      pooledSeen += seen[i], pooledExpected += expected[i];
      continue;
    }
    statistic += (seen[i] - expected[i]) * (seen[i] - expected[i]) / expected[i];
    ++bins;
  }
  if (pooledExpected >= 5) {
    statistic += (pooledSeen - pooledExpected) * (pooledSeen - pooledExpected) / pooledExpected;
    ++bins;
  }
  return oracle::chiSquareP(statistic, bins - 1);
}

inline void expectDensity(double p, double significance, const std::string& what) {
  EXPECT_GT(p, significance) << what;
  measuredAtLeast("least p of chi-square", p, significance);
}

}  // namespace steradian::kernel
