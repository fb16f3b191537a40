// SPDX-License-Identifier: MIT
// Image metrics.
#include "editor/cli/image_compare.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "renderer/scene/error.hpp"

namespace steradian::cli {

namespace {

std::string sizeOf(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

double channel(const Image& image, std::size_t pixel, int c) {
  return image.pixels[pixel * image.channels + (image.channels < 3 ? 0 : c)];
}

double ratio(double a, double b) {
  return a == b ? 1.0 : a / b;
}

}  // namespace

ImageDifference differenceOf(const Image& image, const Image& reference) {
  if (image.width != reference.width || image.height != reference.height)
    throw Error(ExitCode::badInput,
                "the images differ in size: " + sizeOf(image) + " and " + sizeOf(reference));
  ImageDifference out;
  std::array<double, 3> sumA{}, sumB{};
  std::uint64_t count = 0;
  const std::size_t pixels = std::size_t(image.width) * image.height;
  for (std::size_t i = 0; i < pixels; ++i)
    for (int c = 0; c < 3; ++c) {
      const double a = channel(image, i, c), b = channel(reference, i, c);
      out.nan += std::uint64_t(std::isnan(a)) + std::isnan(b);
      out.inf += std::uint64_t(std::isinf(a)) + std::isinf(b);
      if (!std::isfinite(a) || !std::isfinite(b)) continue;
      const double difference = std::abs(a - b), square = difference * difference,
                   sum = std::abs(a) + std::abs(b);
      out.mse += square;
      out.relMse += square / (b * b + 0.01);
      out.smape += sum > 0.0 ? 2.0 * difference / sum : 0.0;
      out.max = std::max(out.max, difference);
      sumA[c] += a;
      sumB[c] += b;
      ++count;
    }
  for (double* mean : {&out.mse, &out.relMse, &out.smape}) *mean /= double(std::max<std::uint64_t>(count, 1));
  out.relRmse = std::sqrt(out.relMse);
  for (int c = 0; c < 3; ++c) out.meanRatio[c] = ratio(sumA[c], sumB[c]);
  return out;
}

}  // namespace steradian::cli
