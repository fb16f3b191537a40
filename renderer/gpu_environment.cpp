// SPDX-License-Identifier: MIT
#include "renderer/gpu_environment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shaders/gpu_types.h"

namespace steradian {
namespace {

constexpr double contrastWorthSamples = 3.0;

/// Of a texel as the shaders weigh it (Rec. 709).
double luminance(const float* rgb) {
  return 0.2126 * double(rgb[0]) + 0.7152 * double(rgb[1]) + 0.0722 * double(rgb[2]);
}

/// Between the heights of a row's edges on the unit sphere, without the cancellation of two cosines.
double bandHeight(int row, int rows) {
  const double step = std::numbers::pi / rows;
  return 2.0 * std::sin((row + 0.5) * step) * std::sin(0.5 * step);
}

/// From the nearer pole to the edge towards it, along the axis: 1 - |cos| of the polar angle.
double distanceFromPole(int row, int rows) {
  const int edges = 2 * row < rows ? row : rows - row - 1;
  const double s = std::sin(0.5 * std::numbers::pi * edges / rows);
  return 2.0 * s * s;
}

/// Shares that grow to exactly 1; even where there is nothing to share.
class Shares {
 public:
  Shares(double total, int count) : total_(total), count_(count) {}
  float next(double weight) {
    ++taken_;
    sum_ += weight;
    if (taken_ == count_) return 1.0f;
    return float(total_ > 0.0 ? std::min(1.0, sum_ / total_) : double(taken_) / count_);
  }

 private:
  double total_, sum_ = 0.0;
  int count_, taken_ = 0;
};

/// Sums of the texels' luminance, row by row.
std::vector<double> rowLuminance(const Image& image) {
  std::vector<double> sums(std::size_t(image.height), 0.0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sums[std::size_t(y)] += luminance(image.at(x, y));
  return sums;
}

}  // namespace

bool skyIsSampled(const Light& light) {
  const auto& sky = std::get<EnvironmentLight>(light.kind);
  if (sky.image) return true;
  const glm::vec3 zenith = lightColor(light);
  const glm::vec3 horizon = zenith * sky.horizon, ground = zenith * sky.ground;
  const auto [least, most] = std::minmax({luminance(&zenith.x), luminance(&horizon.x), luminance(&ground.x)});
  return most > contrastWorthSamples * least;
}

std::vector<glm::vec4> environmentRows(const Light* light, const glm::dmat4& worldFromObject) {
  if (!light) return std::vector<glm::vec4>(gpu::ENVIRONMENT_ROWS, glm::vec4(0.0f));
  const auto& sky = std::get<EnvironmentLight>(light->kind);
  const glm::vec3 zenith = lightColor(*light) * light->intensity;
  const float columns = sky.image ? float(sky.image->width) : 0.0f;
  const float lines = sky.image ? float(sky.image->height) : 0.0f;
  std::vector<glm::vec4> rows{glm::vec4(zenith, columns), glm::vec4(zenith * sky.horizon, lines),
                              glm::vec4(zenith * sky.ground, skyIsSampled(*light) ? 1.0f : 0.0f)};
  // A rotation's inverse is its transpose: the object's axes are the rows.
  for (int i = 0; i < 3; ++i)
    rows.emplace_back(glm::vec3(glm::normalize(glm::dvec3(worldFromObject[i]))), 0.0f);
  return rows;
}

std::vector<glm::vec4> environmentTables(const Image& image) {
  const std::vector<double> sums = rowLuminance(image);
  const double turn = 2.0 * std::numbers::pi / image.width;
  double total = 0.0;
  for (int y = 0; y < image.height; ++y) total += sums[std::size_t(y)] * bandHeight(y, image.height) * turn;
  std::vector<glm::vec4> rows;
  rows.reserve(1 + sums.size() + std::size_t(image.width) * image.height);
  rows.emplace_back(total > 0.0 ? float(1.0 / total) : 0.0f, std::ranges::max(image.pixels), 0.0f, 0.0f);
  Shares down(total, image.height);
  for (int y = 0; y < image.height; ++y) {
    const double height = bandHeight(y, image.height);
    rows.emplace_back(float(distanceFromPole(y, image.height)), float(height), 0.0f,
                      down.next(sums[std::size_t(y)] * height * turn));
  }
  for (int y = 0; y < image.height; ++y) {
    Shares across(sums[std::size_t(y)], image.width);
    for (int x = 0; x < image.width; ++x) {
      const float* texel = image.at(x, y);
      rows.emplace_back(texel[0], texel[1], texel[2], across.next(luminance(texel)));
    }
  }
  return rows;
}

}  // namespace steradian
