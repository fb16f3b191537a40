// SPDX-License-Identifier: MIT
// Reads the sums back, and finds the few pixels that carry most of the error.
#include "renderer/film_sums.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>

#include "renderer/convergence.hpp"
#include "renderer/renderer_impl.hpp"

namespace steradian {

namespace {

struct RowRange {
  int begin = 0, end = 0;
};

Image rgbOf(const gpu::Device& device, const gpu::Buffer& sums, int width, RowRange rows) {
  const int height = rows.end - rows.begin;
  const std::size_t before = std::size_t(width) * rows.begin, pixels = std::size_t(width) * height;
  const gpu::Buffer rgba =
      gpu::readBack(device, sums, before * sizeof(glm::vec4), pixels * sizeof(glm::vec4));
  Image image{width, height, 3, std::vector<float>(pixels * 3)};
  for (std::size_t i = 0; i < pixels; ++i)
    std::memcpy(&image.pixels[i * 3], rgba.map() + i * sizeof(glm::vec4), 3 * sizeof(float));
  return image;
}

FilmSums sumsOf(const gpu::Device& device, const Film& film, bool metered, RowRange rows) {
  FilmSums out;
  for (const int half : {0, 1}) {
    out.sum[half] = rgbOf(device, film.buffers()[2 * half], film.extent().width, rows);
    out.carry[half] = rgbOf(device, film.buffers()[2 * half + 1], film.extent().width, rows);
  }
  out.begin = film.progress.begin;
  out.end = film.progress.done;
  out.endAhead = film.progress.passEnd;
  out.rowsAhead = std::clamp(film.progress.rowsDone - rows.begin, 0, rows.end - rows.begin);
  out.errorMeter = metered;
  return out;
}

/// The squared error of each pixel.
void appendSquares(const FilmSums& sums, std::vector<double>& squares) {
  const Image& shape = sums.sum[0];
  for (int y = 0; y < shape.height; ++y) {
    const double nA = double(sums.count(0, y)), nB = double(sums.count(1, y));
    const double share = nA * nB / ((nA + nB) * (nA + nB));
    for (int x = 0; x < shape.width; ++x) {
      double square = 0.0;
      for (int c = 0; c < 3; ++c) {
        const auto mean = [&](int half, double n) {
          return (double(sums.sum[half].at(x, y)[c]) - sums.carry[half].at(x, y)[c]) / n;
        };
        const double difference = mean(0, nA) - mean(1, nB);
        square += difference * difference * share;
      }
      squares.push_back(square);
    }
  }
}

ErrorTails tailsAmong(std::vector<double> squares) {
  const double total = std::accumulate(squares.begin(), squares.end(), 0.0);
  const auto worst = std::size_t(std::ceil(kTailPixels * double(squares.size())));
  std::partial_sort(squares.begin(), squares.begin() + std::ptrdiff_t(worst), squares.end(),
                    std::greater<>());
  const double carried = std::accumulate(squares.begin(), squares.begin() + std::ptrdiff_t(worst), 0.0);
  return {total > 0.0 ? carried / total : 0.0, worst, false};
}

/// FNV-1a (Fowler, Noll, Vo), 64 bits: tells scenes apart, does not resist an attacker.
std::uint64_t hashOf(const void* data, std::size_t size, std::uint64_t hash) {
  for (const unsigned char byte : std::span(static_cast<const unsigned char*>(data), size))
    hash = (hash ^ byte) * 0x100000001b3ull;
  return hash;
}

}  // namespace

std::uint64_t FilmSums::count(int half, int row) const {
  return samplesOfHalf(begin, row < rowsAhead ? endAhead : end, half, errorMeter);
}

std::uint64_t samplesOfHalf(std::uint64_t begin, std::uint64_t end, int half, bool errorMeter) {
  return halfRange(begin, end, half, errorMeter).count();
}

Image meanOf(const FilmSums& sums) {
  Image mean = sums.sum[0];
  const std::size_t rowValues = std::size_t(mean.width) * std::size_t(mean.channels);
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    const int row = int(i / rowValues);
    double total = 0.0;
    for (int half = 0; half < 2; ++half)
      total += double(sums.sum[half].pixels[i]) - double(sums.carry[half].pixels[i]);
    mean.pixels[i] =
        float(total / double(std::max<std::uint64_t>(sums.count(0, row) + sums.count(1, row), 1)));
  }
  return mean;
}

Image Renderer::radiance() {
  return impl_->film ? meanOf(filmSums()) : Image();
}

ErrorTails tailsOf(const FilmSums& sums) {
  if (!sums.errorMeter || sums.end - sums.begin < 2) return {};
  std::vector<double> squares;
  appendSquares(sums, squares);
  return tailsAmong(std::move(squares));
}

FilmSums Renderer::filmSums() {
  if (!impl_->film) return {};
  const Film& film = impl_->currentFilm();
  return sumsOf(*impl_->device, film, impl_->metered(), {0, film.extent().height});
}

bool Renderer::midPass() const {
  return impl_->film && !impl_->stale && impl_->film->progress.rowsDone > 0;
}

std::uint64_t Renderer::sceneFingerprint() const {
  const GpuScene& s = impl_->scene;
  std::uint64_t hash = hashOf(s.rows.data(), s.rows.size() * sizeof(glm::vec4), 0xcbf29ce484222325ull);
  hash = hashOf(&s.params, sizeof s.params, hash);
  hash = hashOf(&s.features, sizeof s.features, hash);
  const auto add = [&hash](const auto& values) {
    hash = hashOf(values.data(), values.size() * sizeof(values[0]), hash);
  };
  for (const auto& mesh : s.meshes) add(mesh->nodes), add(mesh->triangles);
  for (const auto& vertices : s.vertices) add(vertices->rows);
  for (const auto& texture : s.textures) add(texture->words);
  if (s.environment)
    hash = hashOf(s.environment->pixels.data(), s.environment->pixels.size() * sizeof(float), hash);
  return hash;
}

ErrorTails Renderer::measureTails() {
  impl_->tailSquares.clear();
  // Pixels whose sums fit a CPU's cache: .65 of the time of all at once.
  constexpr std::size_t cached = 1 << 15;
  while (!measureTails(cached)) {
  }
  return impl_->stats.error.tails;
}

bool Renderer::measureTails(std::size_t mostPixels) {
  ErrorEstimate& error = impl_->stats.error;
  std::vector<double>& squares = impl_->tailSquares;
  if (error.valid) {
    // Read some rows more
    const Film& film = impl_->currentFilm();
    const std::size_t width = std::size_t(film.extent().width), height = std::size_t(film.extent().height);
    const std::size_t begin = squares.size() / width;
    const std::size_t rows = std::min(std::max<std::size_t>(mostPixels / width, 1), height - begin);
    appendSquares(sumsOf(*impl_->device, film, impl_->metered(), {int(begin), int(begin + rows)}), squares);
    if (begin + rows < height) return false;
  }
  error.tails = error.valid ? tailsAmong(std::move(squares)) : ErrorTails{};
  error.tails.heavy = heavyTails(error);
  squares.clear();
  return true;
}

}  // namespace steradian
