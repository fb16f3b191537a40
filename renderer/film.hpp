// SPDX-License-Identifier: MIT
// Accumulated samples of one picture on the device, and how far they have come.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/gpu/buffer.hpp"
#include "renderer/gpu/pass.hpp"
#include "renderer/renderer.hpp"
#include "shaders/gpu_types.h"

namespace steradian {

/// Samples are added in passes over all rows; a pass may take many dispatches of some rows each.
struct FilmProgress {
  std::uint64_t begin = 0;    // first sample index
  std::uint64_t done = 0;     // next sample index of every row
  std::uint64_t passEnd = 0;  // done after the pass in progress; == done between passes
  int rowsDone = 0;           // of the pass in progress
};

/// Samples per pixel, those of the pass in progress as far as its rows have come.
double samplesOnAverage(const FilmProgress& progress, int height);

/// Buffers as film.glsl declares them. One thread.
class Film {
 public:
  /// Throws Error(noDevice) when memory or one binding is too small for the extent.
  Film(const gpu::Device& device, Extent extent);

  /// Bind with these buffers (after each new one among them).
  void bind(const gpu::TexelBuffers& scene);
  /// `unit`: see film_unit.hpp.
  void clear(std::uint64_t firstSample, float unit);

  Extent extent() const { return extent_; }
  std::size_t pixels() const { return std::size_t(extent_.width) * extent_.height; }
  /// The whole film as texels, levels, meter and pick results at 4, 6 and 7.
  const gpu::Bindings& bindings() const { return *bindings_; }
  /// What path_trace.comp sees: one half's digits at 1..3, the counters at 5.
  const gpu::Bindings& halfBindings(int half) const { return halfBindings_[half]; }
  /// Low, middle and high digits of half A, then of B.
  const std::array<gpu::Buffer, gpu::filmBuffers>& buffers() const { return buffers_; }
  std::array<const gpu::Buffer*, gpu::filmBuffers> texels() const;
  float unit() const { return unit_; }
  /// Push constants of resolve and meter for what is accumulated now.
  gpu::FilmParams params(bool errorMeter) const;

  FilmProgress progress;

  const gpu::Buffer& partials() const { return partials_; }
  const gpu::Buffer& picked() const { return picked_; }
  const gpu::Buffer& counters() const { return counters_; }
  std::uint32_t meterGroups() const;
  /// Invocations of the meter, each with a part of its own.
  std::size_t meterPartials() const { return std::size_t(meterGroups()) * gpu::METER_GROUP; }

 private:
  const gpu::Device& device_;
  Extent extent_;
  float unit_ = 1.0f;
  std::array<gpu::Buffer, gpu::filmBuffers> buffers_;
  gpu::Buffer levels_, partials_, picked_, counters_;
  std::optional<gpu::Bindings> bindings_;
  std::vector<gpu::Bindings> halfBindings_;
};

/// Indices of half A (even samples) or B (odd) within its own sequence that the samples [begin, end) stand
/// for.
struct HalfRange {
  std::uint32_t begin, end;
  std::uint32_t count() const { return end - begin; }
};
HalfRange halfRange(std::uint64_t begin, std::uint64_t end, int half, bool errorMeter);

}  // namespace steradian
