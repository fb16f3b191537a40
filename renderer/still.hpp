// SPDX-License-Identifier: MIT
// Renders until it is good enough: the loop behind `steradian render`, the bench and the editor's export.
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "renderer/renderer.hpp"

namespace steradian {

/// When to stop: the first condition that is met ends it. At least one must be given.
struct StillRequest {
  std::optional<std::uint64_t> spp;    // samples per pixel
  std::optional<double> untilRelRmse;  // e.g. 0.01; needs the error meter
  std::optional<double> untilSeconds;  // wall time from the call; one whole sample is always finished
  std::uint64_t sampleBegin = 0;       // only sample indices of [sampleBegin, sampleEnd) are traced
  std::uint64_t sampleEnd = std::numeric_limits<std::uint32_t>::max();  // all that the sampler has
  bool wholePasses = false;  // end with the same samples in every row, however early the end (parts)
  double batchMs =
      200.0;  // the longest dispatch; the first ones are shorter, so that a first pixel comes soon
};

struct StillProgress {
  std::uint64_t samples = 0;  // complete, per pixel
  double seconds = 0.0;       // since the call
  double fraction = 0.0;      // 0..1 of the way to the nearest condition
  std::optional<double> remainingSeconds;
  ErrorEstimate error;  // as measured last
};

struct StillCallbacks {
  std::function<void(const StillProgress&)> progress;  // after every batch; may be empty
  std::function<bool()> cancelled;                     // asked after every batch; may be empty
};

enum class StillEnd { samples, error, time, cancelled };

struct StillResult {
  StillEnd end = StillEnd::samples;
  RenderStats stats;                 // with the error measured at the end when the meter runs
  double secondsToFirstPixel = 0.0;  // from the call to the end of the first batch
  double seconds = 0.0;              // wall time of it all
};

/// Renders what renderer.setScene() was told last, from its first sample. On the Renderer's thread.
/// Throws Error(usage) when no condition is given or the sample range is empty; Error(noDevice) on loss.
StillResult renderStill(Renderer& renderer, const StillRequest& request,
                        const StillCallbacks& callbacks = {});

/// The sample count at which to measure the error next, given the last figure at `samples`: about every
/// doubling while far from the target (0 = none), closer near it, so that a render overshoots by a tenth at
/// most.
std::uint64_t nextMeasurement(std::uint64_t samples, const ErrorEstimate& last, double targetRelRmse);

}  // namespace steradian
