// SPDX-License-Identifier: MIT
// Some drivers silently stop all loops of an invocation after 65,535 iterations in all (Mesa lavapipe up
// to 22.3); every GPU must be kept from endless dispatches. This bounds the work of one invocation.
#pragma once
#include "renderer/gpu_scene.hpp"

namespace steradian {

/// Iterations per invocation that a dispatch may plan with.
inline constexpr std::uint64_t cpuDriverLoopBudget = 59'999;  // well below the driver's 65,535
inline constexpr std::uint64_t gpuLoopBudget = 40'000'000;

struct LoopPlan {
  std::uint32_t samplesPerDispatch = 1;
  std::uint32_t lightSamples = 1;  // as asked for, or fewer so that one sample fits
};

/// Loop iterations of one path vertex in the worst case; through the hierarchy in a bad case:
/// `traversalSteps` per ray.
std::uint64_t iterationsPerVertex(const gpu::TraceParams& params, std::uint32_t lightSamples,
                                  double traversalSteps = 0.0);
/// Throws Error(badInput) naming the remedy when not even one sample with one light per vertex fits.
/// `traversals` of one ray, at worst, keep samples per dispatch low, not lights or bounces: most rays need
/// one.
LoopPlan planLoops(const gpu::TraceParams& params, std::uint64_t budget, double traversalSteps = 0.0,
                   double traversals = 1.0);

}  // namespace steradian
