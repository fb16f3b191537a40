// SPDX-License-Identifier: MIT
#include "tests/oracle/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace steradian::oracle {
namespace {

/// Continued fraction of the incomplete beta function, by Lentz' method (Abramowitz & Stegun 26.5.8).
double betaFraction(double a, double b, double x) {
  const auto nonZero = [](double v) { return std::abs(v) < 1e-300 ? 1e-300 : v; };
  double c = 1.0, d = 1.0 / nonZero(1.0 - (a + b) * x / (a + 1.0)), f = d;
  for (int m = 1; m < 10000; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1.0 / nonZero(1.0 + even * d);
    c = nonZero(1.0 + even / c);
    f *= c * d;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1.0 / nonZero(1.0 + odd * d);
    c = nonZero(1.0 + odd / c);
    f *= c * d;
    if (std::abs(c * d - 1.0) < 1e-14) break;
  }
  return f;
}

double regularizedBeta(double a, double b, double x) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
  if (x < (a + 1.0) / (a + b + 2.0)) return front * betaFraction(a, b, x) / a;
  return 1.0 - front * betaFraction(b, a, 1.0 - x) / b;
}

double roundingVariance(double mean) {
  const double error = 1e-6 * std::abs(mean) + 1e-12;
  return error * error;
}

/// The mean over the tile whose first pixel is (x0, y0); degrees of freedom by Satterthwaite 1946.
Measured tileMean(const Estimate& image, int x0, int y0, int tile, int channel) {
  Measured total{0.0, 0.0, 0.0};
  double weights = 0.0;
  int pixels = 0;
  for (int y = y0; y < std::min(y0 + tile, image.height); ++y)
    for (int x = x0; x < std::min(x0 + tile, image.width); ++x, ++pixels) {
      const std::size_t i = std::size_t(y) * image.width + x;
      const double variance = image.variance[i][channel] / image.samples;
      total.mean += image.mean[i][channel];
      total.varianceOfMean += variance;
      weights += variance * variance / (image.samples - 1.0);
    }
  total.degrees = weights > 0.0 ? total.varianceOfMean * total.varianceOfMean / weights : image.samples - 1.0;
  total.mean /= pixels;
  total.varianceOfMean /= double(pixels) * pixels;
  return total;
}

double sumOf(const Estimate& image) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& pixel : image.mean) sum += pixel;
  return sum.x + sum.y + sum.z;
}

std::string describe(int x, int y, int channel, const Measured& a, const Measured& b) {
  char line[200];
  std::snprintf(line, sizeof line, "(%d, %d) channel %d: %.6g +- %.2g against %.6g +- %.2g", x, y, channel,
                a.mean, std::sqrt(a.varianceOfMean), b.mean, std::sqrt(b.varianceOfMean));
  return line;
}

}  // namespace

double studentTwoSided(double t, double degrees) {
  return regularizedBeta(0.5 * degrees, 0.5, degrees / (degrees + t * t));
}

double welch(const Measured& a, const Measured& b) {
  const double va = a.varianceOfMean, vb = b.varianceOfMean;
  const double rounding = roundingVariance(std::max(std::abs(a.mean), std::abs(b.mean)));
  const double variance = va + vb;
  // Rounding is no chance: it widens the spread, and has as many degrees of freedom as one likes.
  const double inDegrees = va * va / a.degrees + vb * vb / b.degrees;
  const double degrees = variance > rounding ? std::min(variance * variance / inDegrees, 1e9) : 1e9;
  return studentTwoSided((a.mean - b.mean) / std::sqrt(variance + rounding), degrees);
}

double sidak(double overall, std::size_t tests) {
  return -std::expm1(std::log1p(-overall) / double(tests));
}

double kolmogorovSmirnov(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double n = double(values.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    distance = std::max({distance, values[i] - double(i) / n, double(i + 1) / n - values[i]});
  const double lambda = (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n)) * distance;
  if (lambda < 0.2) return 1.0;  // where the series below is slow, it is 1 to 12 digits
  double p = 0.0;
  for (int j = 1; j <= 100; ++j) p += (j % 2 ? 2.0 : -2.0) * std::exp(-2.0 * j * j * lambda * lambda);
  return std::clamp(p, 0.0, 1.0);
}

Estimate fromImages(const std::vector<Image>& images) {
  const Image& first = images.front();
  const std::size_t pixels = std::size_t(first.width) * first.height;
  Estimate result{first.width, first.height, double(images.size()), std::vector<glm::dvec3>(pixels),
                  std::vector<glm::dvec3>(pixels)};
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto pixel = [i](const Image& image) {
      const float* p = &image.pixels[3 * i];
      return glm::dvec3(p[0], p[1], p[2]);
    };
    for (const Image& image : images) result.mean[i] += pixel(image) / result.samples;
    for (const Image& image : images) {
      const glm::dvec3 off = pixel(image) - result.mean[i];
      result.variance[i] += off * off / (result.samples - 1.0);
    }
  }
  return result;
}

Agreement compare(const Estimate& ours, const Estimate& oracle, int tile) {
  Agreement agreement;
  agreement.meanRatio = sumOf(ours) / sumOf(oracle);
  std::vector<double> chances, least;
  for (int y = 0; y < oracle.height; y += tile)
    for (int x = 0; x < oracle.width; x += tile) {
      least.push_back(1.0);
      for (int channel = 0; channel < 3; ++channel, ++agreement.tests) {
        const Measured a = tileMean(ours, x, y, tile, channel), b = tileMean(oracle, x, y, tile, channel);
        const double p = welch(a, b);
        least.back() = std::min(least.back(), p);
        if (p <= agreement.smallest) agreement.smallest = p, agreement.worst = describe(x, y, channel, a, b);
        if (channel != 1 || a.varianceOfMean + b.varianceOfMean < 100.0 * roundingVariance(b.mean)) continue;
        chances.push_back(p);
        ++agreement.histogram[std::min(int(10.0 * p), 9)];
      }
    }
  agreement.limit = sidak(1e-4, agreement.tests);
  const double strict = sidak(0.01, agreement.tests);
  const auto passed = std::count_if(least.begin(), least.end(), [&](double p) { return p >= strict; });
  agreement.passing = double(passed) / double(least.size());
  agreement.random = chances.size();
  if (chances.size() >= 16) agreement.uniformity = kolmogorovSmirnov(chances);
  return agreement;
}

std::string report(const Agreement& agreement) {
  char line[300];
  std::snprintf(line, sizeof line,
                "ours / oracle %.5f, smallest p %.2g (limit %.2g) at %s, evenness p %.2g over %zu\n",
                agreement.meanRatio, agreement.smallest, agreement.limit, agreement.worst.c_str(),
                agreement.uniformity, agreement.random);
  std::string text = line;
  for (int i = 0; i < 10; ++i) {
    std::snprintf(line, sizeof line, "  p %.1f..%.1f %4d ", 0.1 * i, 0.1 * (i + 1), agreement.histogram[i]);
    const std::size_t bar =
        60 * std::size_t(agreement.histogram[i]) / std::max<std::size_t>(agreement.random, 1);
    text += line + std::string(bar, '#') + "\n";
  }
  return text;
}

}  // namespace steradian::oracle
