// SPDX-License-Identifier: MIT
// The sampler: below one, stratified, uncorrelated, and as fast to converge as its papers say.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>

#include "shaders/kernel_random.comp.h"
#include "tests/shaders/kernel.hpp"
#include "tests/shaders/oracle.hpp"

namespace steradian::kernel {
namespace {

const Kernel randomKernel{kernel_random_spirv, "random"};

struct Push {
  std::uint32_t samples = 1, dimension = 0, halfBuffer = 0, begin = 0;
};

class Sampler : public KernelTest {
 protected:
  static constexpr std::uint32_t kOwenSobol = 1, kPcg = 3;
  /// (pair x, pair y, independent, another independent) by pixel, then by sample; of PCG two pairs.
  static Rows draw(std::size_t pixels, const Push& push, std::uint32_t sampler = kOwenSobol) {
    return run(
        randomKernel,
        {.operation = sampler, .rowsIn = 0, .invocations = pixels * push.samples, .push = pushBytes(push)},
        {});
  }
};

TEST_F(Sampler, row37_sixteen_million_hashes_never_give_one) {
  const Task task{.operation = 0, .rowsIn = 0, .invocations = 1 << 18, .push = pushBytes(Push{})};
  float largest = 0.0f;
  for (const glm::vec4 answer : run(randomKernel, task, {})) {
    largest = std::max(largest, answer.x);
    ASSERT_EQ(answer.y, 1.0f - 0x1p-24f);
    ASSERT_EQ(answer.z, 0.0f);
  }
  EXPECT_LT(largest, 1.0f);
  measuredAtLeast("1 - the largest number", 1.0 - double(largest), 0x1p-24);
  EXPECT_GT(largest, 0.99999f);
}

TEST_F(Sampler, row37_the_second_sobol_dimension_follows_its_direction_numbers) {
  const Rows answers =
      run(randomKernel, {.operation = 2, .rowsIn = 0, .invocations = 1 << 16, .push = pushBytes(Push{})}, {});
  std::uint32_t directions[32];  // primitive polynomial x + 1 (Joe & Kuo): m_i = 2 m_(i-1) xor m_(i-1)
  for (std::uint32_t i = 0, m = 1; i < 32; ++i, m = (m << 1) ^ m) directions[i] = m << (31 - i);
  for (const glm::vec4 answer : answers) {
    const std::uint32_t index = std::uint32_t(answer.x) << 16 | std::uint32_t(answer.y);
    const std::uint32_t reversed = std::uint32_t(answer.z) << 16 | std::uint32_t(answer.w);
    std::uint32_t sobol = 0, mirrored = 0;
    for (int bit = 0; bit < 32; ++bit) {
      if (index >> bit & 1u) sobol ^= directions[bit];
      mirrored |= (reversed >> bit & 1u) << (31 - bit);
    }
    ASSERT_EQ(mirrored, sobol) << "index " << index;
  }
  measuredAtLeast("points that follow", double(answers.size()), 1 << 16);
}

/// Whether 2^k points put exactly one into each elementary interval of every shape.
bool isNet(const glm::vec4* points, int k) {
  for (int split = 0; split <= k; ++split) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
    for (int i = 0; i < 1 << k; ++i)
      cells.emplace(std::uint32_t(std::ldexp(points[i].x, split)),
                    std::uint32_t(std::ldexp(points[i].y, k - split)));
    if (cells.size() != std::size_t(1) << k) return false;
  }
  return true;
}

TEST_F(Sampler, row37_every_aligned_block_of_samples_is_a_net) {
  constexpr int samples = 1024, pixels = 8;
  int nets = 0;
  for (const std::uint32_t dimension : {0u, 1u, 5u})
    for (const std::uint32_t begin : {0u, 1u << 20}) {
      const Rows points = draw(pixels, {.samples = samples, .dimension = dimension, .begin = begin});
      for (int pixel = 0; pixel < pixels; ++pixel)
        for (int k = 0; k <= 10; ++k)
          for (int block = 0; block < samples >> k; ++block, ++nets)
            ASSERT_TRUE(isNet(&points[pixel * samples + (block << k)], k))
                << "pixel " << pixel << ", dimension " << dimension << ", block " << block << " of 2^" << k;
    }
  measuredAtLeast("blocks that are nets", nets, 3 * 2 * pixels * (2 * samples - 1));
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - 0.5) * (b[i] - 0.5);
  return 12.0 * sum / double(a.size());  // the variance of a uniform number is 1/12
}

TEST_F(Sampler, row37_pixels_dimensions_and_halves_are_uncorrelated) {
  constexpr std::size_t n = 1 << 16;
  // One sample per pixel: neighbours, dimensions, half-buffers and sample indices are then all independent.
  std::vector<std::vector<double>> series;
  const Push pushes[] = {{.dimension = 0},
                         {.dimension = 1},
                         {.dimension = 2},
                         {.dimension = 0, .halfBuffer = 1},
                         {.dimension = 0, .begin = 1},
                         {.dimension = 0, .begin = 2}};
  for (const Push& push : pushes) {
    const Rows points = draw(n, push);
    for (int component = 0; component < 4; ++component) {
      series.emplace_back();
      for (const glm::vec4& p : points) series.back().push_back(double(p[component]));
    }
  }
  const double gate = 4.0 / std::sqrt(double(n));
  for (std::size_t a = 0; a < series.size(); ++a) {
    for (const std::size_t shift : {1u, 2u, 512u}) {  // next pixels in x, and the next row
      std::vector<double> moved = series[a];
      std::rotate(moved.begin(), moved.begin() + long(shift), moved.end());
      EXPECT_LT(std::fabs(correlation(series[a], moved)), gate) << "series " << a << " shifted by " << shift;
      measured("correlation", std::fabs(correlation(series[a], moved)), gate);
    }
    for (std::size_t b = a + 1; b < series.size(); ++b) {
      const bool samePairOfPixel = a % 4 < 2 && b % 4 < 2 && (a / 4 == 0 || a / 4 >= 4) && b / 4 >= 4;
      if (samePairOfPixel) continue;  // consecutive indices of one stratified sequence repel each other
      EXPECT_LT(std::fabs(correlation(series[a], series[b])), gate) << "series " << a << " and " << b;
      measured("correlation", std::fabs(correlation(series[a], series[b])), gate);
    }
  }
}

TEST_F(Sampler, row37_each_sample_alone_is_uniform_in_the_square) {
  // Over pixels one sample of a fixed index must fill the square, or the estimate is biased: the two
  // scrambles of a pair and the shuffle of its index may not share bits.
  constexpr int cells = 16;
  constexpr std::size_t pixels = 1 << 18;
  for (const std::uint32_t index : {0u, 1u, 2u, 3u, 100u})
    for (const std::uint32_t dimension : {0u, 3u}) {
      std::vector<double> seen(cells * cells, 0.0);
      for (const glm::vec4& p : draw(pixels, {.dimension = dimension, .begin = index}))
        seen[std::size_t(p.x * cells) * cells + std::size_t(p.y * cells)] += 1.0;
      const double expected = double(pixels) / (cells * cells);
      double statistic = 0;
      for (const double count : seen) statistic += (count - expected) * (count - expected) / expected;
      EXPECT_GT(oracle::chiSquareP(statistic, cells * cells - 1), 1e-4)
          << "index " << index << ", dimension " << dimension << ": chi-square " << statistic;
      measuredAtLeast("least p of chi-square", oracle::chiSquareP(statistic, cells * cells - 1), 1e-4);
    }
}

TEST_F(Sampler, row37_pcg_is_the_published_hash) {
  constexpr std::uint32_t count = 1024, begin = 5;
  const Rows answers =
      run(randomKernel,
          {.operation = 4, .rowsIn = 0, .invocations = count, .push = pushBytes(Push{.begin = begin})}, {});
  for (std::uint32_t at = 0; at < count; ++at) {
    // Listing of Jarzynski & Olano 2020, one integer after the other.
    std::uint32_t x = (begin + at) * 1664525u + 1013904223u, y = at * 3u * 1664525u + 1013904223u,
                  z = 7u * 1664525u + 1013904223u;
    for (const bool last : {false, true}) {
      x += y * z, y += z * x, z += x * y;
      if (!last) x ^= x >> 16, y ^= y >> 16, z ^= z >> 16;
    }
    const glm::vec4& answer = answers[at];
    ASSERT_EQ(std::uint32_t(answer.x) << 16 | std::uint32_t(answer.y), x);
    ASSERT_EQ(std::uint32_t(answer.z) << 16 | std::uint32_t(answer.w), y);
  }
  measuredAtLeast("hashes that agree", count, count);
}

TEST_F(Sampler, row37_pcg_numbers_are_uniform_and_independent) {
  constexpr std::size_t n = 1 << 16;
  constexpr int cells = 16;
  std::vector<std::vector<double>> series;
  for (const Push& push : {Push{.dimension = 0}, Push{.dimension = 2}, Push{.dimension = 0, .halfBuffer = 1},
                           Push{.dimension = 0, .begin = 1}}) {
    const Rows points = draw(n, push, kPcg);
    std::vector<double> seen(cells * cells, 0.0);
    for (const glm::vec4& p : points)
      seen[std::size_t(p.x * cells) * cells + std::size_t(p.y * cells)] += 1.0;
    const double expected = double(n) / (cells * cells);
    double statistic = 0;
    for (const double c : seen) statistic += (c - expected) * (c - expected) / expected;
    EXPECT_GT(oracle::chiSquareP(statistic, cells * cells - 1), 1e-4) << "chi-square " << statistic;
    measuredAtLeast("least p of chi-square", oracle::chiSquareP(statistic, cells * cells - 1), 1e-4);
    for (int component = 0; component < 4; ++component) {
      series.emplace_back();
      for (const glm::vec4& p : points) series.back().push_back(double(p[component]));
    }
  }
  const double gate = 4.0 / std::sqrt(double(n));
  for (std::size_t a = 0; a < series.size(); ++a)
    for (std::size_t b = a + 1; b < series.size(); ++b) {
      EXPECT_LT(std::fabs(correlation(series[a], series[b])), gate) << "series " << a << " and " << b;
      measured("correlation", std::fabs(correlation(series[a], series[b])), gate);
    }
}

using Integrand = std::function<double(double, double)>;

/// Slope of log RMSE over log N from 2^6 to 2^12, over 256 pixels; x and y are the components drawn.
double slopeOf(const Rows& points, const Integrand& f, double truth, int x, int y) {
  constexpr int samples = 4096, pixels = 256;
  std::vector<double> squares(13, 0.0);
  for (int pixel = 0; pixel < pixels; ++pixel) {
    double sum = 0.0;
    for (int i = 0, k = 0; i < samples; ++i) {
      const glm::vec4& p = points[std::size_t(pixel * samples + i)];
      sum += f(double(p[x]), double(p[y]));
      if (i + 1 == 1 << k) squares[std::size_t(k++)] += std::pow(sum / (i + 1) - truth, 2.0);
    }
  }
  double sxy = 0.0, sxx = 0.0;
  for (int k = 6; k <= 12; ++k) {
    const double x0 = (k - 9) * std::log(2.0);
    sxy += x0 * 0.5 * std::log(squares[std::size_t(k)]);
    sxx += x0 * x0;
  }
  return sxy / sxx;
}

TEST_F(Sampler, row37_errors_fall_at_the_rates_of_theory) {
  const Rows points = draw(256, {.samples = 4096});
  const Integrand smooth = [](double x, double y) { return std::exp(x) * std::sin(M_PI * y); };
  const double smoothTruth = (std::exp(1.0) - 1.0) * 2.0 / M_PI;
  const Integrand disc = [](double x, double y) { return x * x + y * y < 0.64 ? 1.0 : 0.0; };
  const double discTruth = 0.16 * M_PI;
  const double smoothly = slopeOf(points, smooth, smoothTruth, 2, 3);
  const double edgy = slopeOf(points, disc, discTruth, 2, 3);
  EXPECT_NEAR(smoothly, -0.5, 0.05) << "independent, smooth";
  EXPECT_NEAR(edgy, -0.5, 0.05) << "independent, edge";
  measured("independent: distance of the slope from -1/2", std::fabs(smoothly + 0.5), 0.05);
  measured("independent: distance of the slope from -1/2", std::fabs(edgy + 0.5), 0.05);
  const Rows pcg = draw(256, {.samples = 4096}, kPcg);
  for (const double slope : {slopeOf(pcg, smooth, smoothTruth, 0, 1), slopeOf(pcg, disc, discTruth, 0, 1)}) {
    EXPECT_NEAR(slope, -0.5, 0.05) << "PCG";
    measured("PCG: distance of the slope from -1/2", std::fabs(slope + 0.5), 0.05);
  }
  const double edge = slopeOf(points, disc, discTruth, 0, 1);
  EXPECT_LT(edge, -0.65) << "Owen-scrambled, edge";
  EXPECT_GT(edge, -0.8) << "Owen-scrambled, edge";
  measuredAtLeast("Owen-scrambled: -slope at an edge", -edge, 0.65);
  measured("Owen-scrambled: the same, at most", -edge, 0.8);
  const double fast = slopeOf(points, smooth, smoothTruth, 0, 1);
  EXPECT_LT(fast, -1.25) << "Owen-scrambled, smooth";
  EXPECT_GT(fast, -1.5) << "Owen-scrambled, smooth";
  measuredAtLeast("Owen-scrambled: -slope where smooth", -fast, 1.25);
  measured("Owen-scrambled: -slope where smooth, at most", -fast, 1.5);
}

}  // namespace
}  // namespace steradian::kernel
