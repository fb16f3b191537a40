// SPDX-License-Identifier: MIT
#include "renderer/loop_budget.hpp"

#include <algorithm>

namespace steradian {
namespace {

std::uint64_t primitives(const gpu::TraceParams& p) {
  return std::uint64_t(p.sphereCount) + p.planeCount + p.largeSphereCount + p.boxCount + p.rectCount +
         p.diskCount + p.cylinderCount + p.ellipsoidCount;
}

}  // namespace

std::uint64_t iterationsPerVertex(const gpu::TraceParams& params, std::uint32_t lightSamples) {
  constexpr std::uint64_t loopsPerTraversal = 8;  // each kind's loop also counts its last, failing test
  const std::uint64_t traversal = primitives(params) + loopsPerTraversal;
  return 1 + traversal * (1 + lightSamples) + lightSamples + 1;
}

LoopPlan planLoops(const gpu::TraceParams& params, std::uint64_t budget) {
  const std::uint64_t vertices = params.maxBounces + 1;
  LoopPlan plan;
  plan.lightSamples = std::min(params.lightSamples, std::max(params.lightCount, 1u));
  while (plan.lightSamples > 1 && iterationsPerVertex(params, plan.lightSamples) * vertices > budget)
    plan.lightSamples -= 1;
  const std::uint64_t perSample = iterationsPerVertex(params, plan.lightSamples) * vertices;
  if (perSample > budget) {
    const std::uint64_t fitting = budget / iterationsPerVertex(params, 1);
    throw Error(ExitCode::badInput,
                "This scene has " + std::to_string(primitives(params)) + " shapes; with " +
                    std::to_string(params.maxBounces) + " bounces one path needs " +
                    std::to_string(perSample) +
                    " loop iterations, this device's driver stops at 65,535. Set the bounces to " +
                    std::to_string(fitting > 0 ? fitting - 1 : 0) + " or less, hide shapes, or use a GPU.");
  }
  plan.samplesPerDispatch = std::uint32_t(std::min<std::uint64_t>(budget / perSample, 4096));
  return plan;
}

}  // namespace steradian
