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

using Digits = std::array<gpu::Buffer, gpu::FILM_DIGITS>;

Digits digitsOf(const gpu::Device& device, const gpu::Buffer* film, std::size_t firstPixel,
                std::size_t pixels) {
  Digits read;
  for (std::size_t i = 0; i < read.size(); ++i)
    read[i] = gpu::readBack(device, film[i], firstPixel * sizeof(glm::ivec4), pixels * sizeof(glm::ivec4));
  return read;
}

std::vector<FilmSum> sumsOf(const Digits& digits, std::size_t pixels) {
  const auto digit = [&](std::size_t which, std::size_t pixel, std::size_t channel) {
    std::int32_t value;
    std::memcpy(&value, digits[which].map() + (pixel * 4 + channel) * sizeof value, sizeof value);
    return value;
  };
  std::vector<FilmSum> sums(pixels * 3);
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] = {digit(0, i / 3, i % 3), digit(1, i / 3, i % 3), digit(2, i / 3, i % 3)};
  return sums;
}

FilmSums sumsOf(const gpu::Device& device, const Film& film, bool metered, RowRange rows) {
  const int width = film.extent().width;
  FilmSums out{width, rows.end - rows.begin, {}, film.unit()};
  const std::size_t before = std::size_t(width) * rows.begin, pixels = std::size_t(width) * out.height;
  for (const int half : {0, 1}) {
    const gpu::Buffer* const own = &film.buffers()[half * gpu::FILM_DIGITS];
    out.sums[half] = sumsOf(digitsOf(device, own, before, pixels), pixels);
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
  for (int y = 0; y < sums.height; ++y) {
    const double nA = double(sums.count(0, y)), nB = double(sums.count(1, y));
    const double share = nA * nB / ((nA + nB) * (nA + nB));
    for (int x = 0; x < sums.width; ++x) {
      const std::size_t first = (std::size_t(y) * sums.width + x) * 3;
      double square = 0.0;
      for (std::size_t at = first; at < first + 3; ++at) {
        const double difference = sums.radiance(0, at) / nA - sums.radiance(1, at) / nB;
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

__extension__ using Quanta = __int128;  // unit / FILM_BASE^2

Quanta quantaOf(const FilmSum& sum) {
  return (Quanta(sum.high) * gpu::FILM_BASE + sum.middle) * gpu::FILM_BASE + sum.low;
}

double radianceOf(Quanta quanta, double unit) {
  return double(quanta) * std::ldexp(unit, -2 * gpu::FILM_DIGIT_BITS);
}

/// `value(row, at)` for all values.
template <class Value>
Image imageOf(const FilmSums& sums, Value&& value) {
  Image image{sums.width, sums.height, 3, std::vector<float>(sums.sums[0].size())};
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = float(value(int(i / (std::size_t(sums.width) * 3)), i));
  return image;
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

double FilmSums::radiance(int half, std::size_t at) const {
  return radianceOf(quantaOf(sums[half][at]), unit);
}

std::array<double, 3> FilmSums::terms(int half, std::size_t at) const {
  const FilmSum& sum = sums[half][at];
  const double perBase = 1.0 / gpu::FILM_BASE;
  return {sum.high * unit, sum.middle * (unit * perBase), sum.low * (unit * perBase * perBase)};
}

double FilmSums::radiance(std::size_t at) const {
  return radianceOf(quantaOf(sums[0][at]) + quantaOf(sums[1][at]), unit);
}

bool FilmSums::full(std::size_t at) const {
  static const auto most = std::int32_t(std::nextafter(float(gpu::FILM_BASE), 0.0f));  // film_sum.glsl
  return std::max(std::abs(sums[0][at].high), std::abs(sums[1][at].high)) >= most;
}

Image meanOf(const FilmSums& sums) {
  return imageOf(sums, [&](int row, std::size_t at) {
    return sums.radiance(at) / double(std::max<std::uint64_t>(sums.count(0, row) + sums.count(1, row), 1));
  });
}

std::pair<Image, Image> Renderer::halves() {
  const FilmSums sums = filmSums();
  const auto mean = [&](int half) {
    return imageOf(sums, [&](int row, std::size_t at) {
      return sums.radiance(half, at) / double(std::max<std::uint64_t>(sums.count(half, row), 1));
    });
  };
  return {mean(0), mean(1)};
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
  hash = hashOf(&s.filmUnit, sizeof s.filmUnit, hash);
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
