// SPDX-License-Identifier: MIT
// The tests that decide about agreement: against tables, and on noise whose truth is known.
#include "tests/oracle/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracle/random.hpp"

namespace steradian::oracle {
namespace {

double exponential(Random& random, double mean) {
  return -mean * std::log1p(-random.uniform());
}

/// 16 pictures of exponential noise around `ours`, and an estimate of 4096 samples around `truth`.
Agreement ofNoise(double ours, double truth, unsigned seedNumber, int tile = 1) {
  std::seed_seq seed{seedNumber};
  Random random(seed);
  constexpr int size = 16;
  std::vector<Image> images(16, Image{size, size, 3, std::vector<float>(size * size * 3)});
  for (Image& image : images)
    for (float& pixel : image.pixels)
      for (int i = 0; i < 64; ++i) pixel += float(exponential(random, ours) / 64.0);
  Estimate oracle{size, size, 1024.0, std::vector<glm::dvec3>(size * size),
                  std::vector<glm::dvec3>(size * size)};
  for (int i = 0; i < size * size; ++i)
    for (int c = 0; c < 3; ++c) {
      double sum = 0.0, squares = 0.0;
      for (int k = 0; k < 1024; ++k) {
        const double v = exponential(random, truth);
        sum += v, squares += v * v;
      }
      oracle.mean[i][c] = sum / 1024.0;
      oracle.variance[i][c] = (squares - sum * sum / 1024.0) / 1023.0;
    }
  return compare(fromImages(images), oracle, tile);
}

TEST(OracleStatistics, StudentsTailsAreThoseOfTheTables) {
  EXPECT_NEAR(studentTwoSided(12.7062047, 1), 0.05, 1e-8);
  EXPECT_NEAR(studentTwoSided(2.13144955, 15), 0.05, 1e-8);
  EXPECT_NEAR(studentTwoSided(2.94671288, 15), 0.01, 1e-8);
  EXPECT_NEAR(studentTwoSided(1.95996398, 1e8), 0.05, 1e-7);
  EXPECT_NEAR(studentTwoSided(5.0, 1e8) / 5.7330314e-7, 1.0, 1e-4);
  EXPECT_DOUBLE_EQ(studentTwoSided(0.0, 3), 1.0);
}

TEST(OracleStatistics, WelchWeighsBothSpreads) {
  // Welch 1947's degrees of freedom for s^2 / n of 0.5 (n = 5) and 0.1 (n = 11)
  const double degrees = 0.36 / (0.25 / 4.0 + 0.01 / 10.0);
  EXPECT_NEAR(welch({3.0, 0.5, 4.0}, {1.0, 0.1, 10.0}), studentTwoSided(2.0 / std::sqrt(0.6), degrees), 1e-6);
}

TEST(OracleStatistics, RoundingAloneIsNoDifference) {
  EXPECT_GT(welch({1.0, 0.0, 15.0}, {1.0 + 1e-6, 0.0, 100.0}), 0.1);
  EXPECT_LT(welch({1.0, 0.0, 15.0}, {1.0 + 1e-5, 0.0, 100.0}), 1e-15);
  EXPECT_EQ(welch({0.0, 0.0, 15.0}, {0.0, 0.0, 100.0}), 1.0);
}

TEST(OracleStatistics, SidakKeepsTheOverallChance) {
  EXPECT_NEAR(1.0 - std::pow(1.0 - sidak(0.01, 50), 50.0), 0.01, 1e-12);
  EXPECT_NEAR(sidak(1e-4, 1), 1e-4, 1e-15);
}

TEST(OracleStatistics, KolmogorovSmirnovKnowsEvenFromCrowded) {
  std::vector<double> even, crowded;
  for (int i = 0; i < 200; ++i)
    even.push_back((i + 0.5) / 200.0), crowded.push_back(std::pow((i + 0.5) / 200.0, 2.0));
  EXPECT_GT(kolmogorovSmirnov(even), 0.999);
  EXPECT_LT(kolmogorovSmirnov(crowded), 1e-6);
  // Critical value of the limit distribution: lambda = 1.3581 at 5 %
  std::vector<double> shifted;
  const int n = 100000;
  for (int i = 0; i < n; ++i) shifted.push_back((i + 0.5) / n * (1.0 - 1.3581 / std::sqrt(double(n))));
  EXPECT_NEAR(kolmogorovSmirnov(shifted), 0.05, 0.001);
}

TEST(OracleStatistics, EqualTruthsAgreeAndTheirChancesAreEven) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Agreement agreement = ofNoise(1.0, 1.0, seed);
    EXPECT_TRUE(agreement.holds()) << report(agreement);
    EXPECT_EQ(agreement.random, 256u);
    EXPECT_GE(agreement.passing, 0.9975) << report(agreement);
    EXPECT_GT(agreement.uniformity, 0.01) << report(agreement);
  }
}

TEST(OracleStatistics, ASmallBiasIsFoundByEvennessOrByTiles) {
  const Agreement pixels = ofNoise(1.06, 1.0, 9), tiles = ofNoise(1.03, 1.0, 9, 4);
  EXPECT_FALSE(pixels.holds()) << report(pixels);
  EXPECT_LT(tiles.smallest, 1e-5) << report(tiles);
  EXPECT_NEAR(pixels.meanRatio, 1.06, 0.01);
  EXPECT_LT(ofNoise(2.0, 1.0, 9).passing, 0.5);
}

}  // namespace
}  // namespace steradian::oracle
