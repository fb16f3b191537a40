// SPDX-License-Identifier: MIT
// How wrong the picture still is, and the counters of a film, by one reduction on the device.
#pragma once
#include "renderer/convergence.hpp"
#include "renderer/film.hpp"
#include "renderer/gpu/commands.hpp"

namespace steradian {

struct MeterReading {
  double meanSquare = 0.0;          // of the joint mean's error, over pixels and channels
  double meanRelativeSquare = 0.0;  // divided by light^2 + 0.01 (relative_error.glsl)
  std::uint64_t nan = 0, faults = 0, raysClosest = 0, raysShadow = 0;
  double clampedShare = 0.0;  // of the light, by luminance: cut off by clamping / (cut off + kept)
};

class ErrorMeter {
 public:
  explicit ErrorMeter(const gpu::Device& device);
  /// `clampRadiance` as the film was traced with, nit; 0 = off.
  MeterReading read(const Film& film, bool errorMeter, double clampRadiance);

 private:
  const gpu::Device& device_;
  gpu::ComputePass level_, pass_;
  gpu::Commands commands_;
};

}  // namespace steradian
