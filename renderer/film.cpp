// SPDX-License-Identifier: MIT
#include "renderer/film.hpp"

namespace steradian {

using namespace gpu;

Film::Film(const Device& device, Extent extent) : device_(device), extent_(extent) {
  const std::size_t bytes = pixels() * 16;
  for (Buffer& b : buffers_) b = Buffer(device, BufferKind::deviceLocal, bytes, "film");
  partials_ =
      Buffer(device, BufferKind::deviceLocal, std::size_t(meterGroups()) * METER_ROWS * 16, "error meter");
  picked_ = Buffer(device, BufferKind::deviceLocal, PICK_ROWS * 16, "pick");
}

void Film::bind(const Buffer& rows) {
  const Buffer* const storage[] = {&buffers_[0], &buffers_[1], &buffers_[2], &buffers_[3],
                                   nullptr,      &partials_,   &picked_};
  bindings_.emplace(device_, &rows, storage);
}

void Film::clear(std::uint64_t firstSample) {
  device_.run(QueueKind::compute, [&](const auto& cmd) {
    for (const Buffer& b : buffers_) recordFillZero(cmd, b);
  });
  progress = {firstSample, firstSample, firstSample, 0};
}

FilmParams Film::params(bool errorMeter) const {
  FilmParams p{};
  p.width = std::uint32_t(extent_.width);
  p.height = std::uint32_t(extent_.height);
  p.splitRow = std::uint32_t(progress.rowsDone);
  p.aheadA = halfCount(progress.begin, progress.passEnd, 0, errorMeter);
  p.aheadB = halfCount(progress.begin, progress.passEnd, 1, errorMeter);
  p.samplesA = halfCount(progress.begin, progress.done, 0, errorMeter);
  p.samplesB = halfCount(progress.begin, progress.done, 1, errorMeter);
  p.relativeFloor = 0.01f;
  return p;
}

std::uint32_t Film::meterGroups() const {
  return std::uint32_t((pixels() + METER_PIXELS - 1) / METER_PIXELS);
}

std::uint32_t halfCount(std::uint64_t begin, std::uint64_t end, int half, bool errorMeter) {
  if (!errorMeter) return half == 0 ? std::uint32_t(end - begin) : 0;
  const auto upTo = [&](std::uint64_t n) { return half == 0 ? (n + 1) / 2 : n / 2; };
  return std::uint32_t(upTo(end) - upTo(begin));
}

}  // namespace steradian
