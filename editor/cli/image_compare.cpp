// SPDX-License-Identifier: MIT
// Image metrics.
#include "editor/cli/image_compare.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
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

/// What a screen shows, in [0, 1]: clipped, and by IEC 61966-2-1 unless it is encoded already.
double displayed(double value, Encoding encoding) {
  const double v = std::clamp(value, 0.0, 1.0);
  if (encoding == Encoding::display) return v;
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
}

double symmetric(double a, double b) {
  const double sum = std::abs(a) + std::abs(b);
  return sum > 0.0 ? 2.0 * std::abs(a - b) / sum : 0.0;
}

double ratio(double a, double b) {
  return a == b ? 1.0 : a / b;
}

}  // namespace

ImageDifference differenceOf(const Image& image, const Image& reference, Encodings encodings) {
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
      const double difference = std::abs(a - b), square = difference * difference;
      out.mse += square;
      out.relMse += square / (b * b + 0.01);
      out.smape += symmetric(a, b);
      out.smapeDisplay += symmetric(displayed(a, encodings.image), displayed(b, encodings.reference));
      out.max = std::max(out.max, difference);
      sumA[c] += a;
      sumB[c] += b;
      ++count;
    }
  for (double* mean : {&out.mse, &out.relMse, &out.smape, &out.smapeDisplay})
    *mean /= double(std::max<std::uint64_t>(count, 1));
  out.rmse = std::sqrt(out.mse);
  out.relRmse = std::sqrt(out.relMse);
  for (int c = 0; c < 3; ++c) out.meanRatio[c] = ratio(sumA[c], sumB[c]);
  return out;
}

std::vector<std::pair<std::string, double>> figuresOf(const ImageDifference& d) {
  return {{"mse", d.mse},         {"rmse", d.rmse},   {"relMse", d.relMse},
          {"relRmse", d.relRmse}, {"smape", d.smape}, {"smapeDisplay", d.smapeDisplay},
          {"max", d.max}};
}

FigureLimit parseLimit(const std::string& text) {
  const std::size_t equals = text.find('=');
  std::string known;
  bool found = false;
  for (const auto& [name, value] : figuresOf({})) {
    known += (known.empty() ? "" : ", ") + name;
    found = found || (equals != text.npos && text.compare(0, equals, name) == 0);
  }
  FigureLimit limit{text.substr(0, equals), 0.0};
  const char* begin = text.data() + (found ? equals + 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), limit.atMost);
  if (!found || error != std::errc() || end != text.data() + text.size() || !(limit.atMost >= 0.0))
    throw Error(ExitCode::usage,
                "--fail-above: '" + text + "' is not valid; expected FIGURE=NUMBER with one of " + known);
  return limit;
}

std::vector<std::string> exceeded(const ImageDifference& difference, const std::vector<FigureLimit>& limits) {
  std::vector<std::string> lines;
  for (const FigureLimit& limit : limits)
    for (const auto& [name, value] : figuresOf(difference)) {
      if (name != limit.figure || value <= limit.atMost) continue;
      char line[96];
      std::snprintf(line, sizeof line, "%s is %.6g, above %.6g", name.c_str(), value, limit.atMost);
      lines.push_back(line);
    }
  if (!limits.empty() && difference.nan + difference.inf > 0)
    lines.push_back("values that are not finite: " + std::to_string(difference.nan + difference.inf));
  return lines;
}

}  // namespace steradian::cli
