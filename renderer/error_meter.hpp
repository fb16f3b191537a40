// SPDX-License-Identifier: MIT
// How wrong the picture still is, and the counters of a film, by one reduction on the device.
#pragma once
#include "renderer/film.hpp"
#include "renderer/gpu/commands.hpp"

namespace steradian {

struct MeterReading {
  double meanSquare = 0.0;          // of the joint mean's error, over pixels and channels
  double meanRelativeSquare = 0.0;  // divided by mean^2 + 0.01
  std::uint64_t nan = 0, faults = 0, raysClosest = 0, raysShadow = 0;
};

class ErrorMeter {
 public:
  explicit ErrorMeter(const gpu::Device& device);
  MeterReading read(const Film& film, bool errorMeter);

 private:
  const gpu::Device& device_;
  gpu::ComputePass pass_;
  gpu::Commands commands_;
};

/// Keeps RMSE at the doublings of the sample count and gives the slope of the last doubling.
class SlopeTracker {
 public:
  void reset() { *this = {}; }
  double add(std::uint64_t samples, double rmse);

 private:
  std::uint64_t samples_ = 0;
  double rmse_ = 0.0;
  double slope_ = 0.0;
};

}  // namespace steradian
