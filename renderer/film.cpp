// SPDX-License-Identifier: MIT
#include "renderer/film.hpp"

#include "renderer/relative_error.hpp"

namespace steradian {

using namespace gpu;

double samplesOnAverage(const FilmProgress& p, int height) {
  return double(p.done - p.begin) + double(p.passEnd - p.done) * p.rowsDone / height;
}

Film::Film(const Device& device, Extent extent) : device_(device), extent_(extent) {
  const std::size_t bytes = pixels() * 16;
  for (Buffer& b : buffers_) b = Buffer(device, BufferKind::film, bytes, "film");
  levels_ = Buffer(device, BufferKind::deviceLocal, bytes, "light of the pixels");
  partials_ = Buffer(device, BufferKind::deviceLocal, meterPartials() * METER_ROWS * 16, "error meter");
  picked_ = Buffer(device, BufferKind::deviceLocal, PICK_ROWS * 16, "pick");
  counters_ = Buffer(device, BufferKind::deviceLocal, COUNTERS * 4, "counters");
}

void Film::bind(const TexelBuffers& scene) {
  const Buffer* const written[] = {nullptr, nullptr, nullptr, &levels_, nullptr, &partials_, &picked_};
  TexelBuffers read = scene;
  read.film = texels();
  bindings_.emplace(device_, read, written);
  halfBindings_.clear();
  for (const int half : {0, 1}) {
    const Buffer* const digits = &buffers_[half * FILM_DIGITS];
    const Buffer* const own[] = {digits, digits + 1, digits + 2, nullptr, &counters_};
    TexelBuffers before = scene;
    before.film = {digits, digits + 1, digits + 2};
    halfBindings_.emplace_back(device_, before, own);
  }
}

std::array<const Buffer*, filmBuffers> Film::texels() const {
  std::array<const Buffer*, filmBuffers> all;
  for (std::size_t i = 0; i < filmBuffers; ++i) all[i] = &buffers_[i];
  return all;
}

void Film::clear(std::uint64_t firstSample, float unit) {
  device_.run(QueueKind::compute, [&](const auto& cmd) {
    for (const Buffer& b : buffers_) recordFillZero(cmd, b);
    recordFillZero(cmd, counters_);
  });
  progress = {firstSample, firstSample, firstSample, 0};
  unit_ = unit;
}

FilmParams Film::params(bool errorMeter) const {
  FilmParams p{};
  p.width = std::uint32_t(extent_.width);
  p.height = std::uint32_t(extent_.height);
  p.splitPixel = std::uint32_t(progress.rowsDone) * p.width;
  p.aheadA = halfRange(progress.begin, progress.passEnd, 0, errorMeter).count();
  p.aheadB = halfRange(progress.begin, progress.passEnd, 1, errorMeter).count();
  p.samplesA = halfRange(progress.begin, progress.done, 0, errorMeter).count();
  p.samplesB = halfRange(progress.begin, progress.done, 1, errorMeter).count();
  p.relativeFloor = float(kRelativeFloor);
  p.filmUnit = unit_;
  return p;
}

std::uint32_t Film::meterGroups() const {
  const auto parts = [](int size, std::uint32_t each) { return (std::uint32_t(size) + each - 1) / each; };
  return parts(extent_.width, METER_GROUP) * parts(extent_.height, METER_PIXELS);
}

HalfRange halfRange(std::uint64_t begin, std::uint64_t end, int half, bool errorMeter) {
  if (!errorMeter) return half == 0 ? HalfRange{std::uint32_t(begin), std::uint32_t(end)} : HalfRange{0, 0};
  const auto upTo = [&](std::uint64_t n) { return std::uint32_t(half == 0 ? (n + 1) / 2 : n / 2); };
  return {upTo(begin), upTo(end)};
}

}  // namespace steradian
