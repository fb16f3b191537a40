// SPDX-License-Identifier: MIT
#include "renderer/loop_budget.hpp"

#include <algorithm>

#include "renderer/gpu_environment.hpp"
#include "renderer/light_tree.hpp"

namespace steradian {
namespace {

std::uint64_t shapes(const gpu::TraceParams& p) {
  return std::uint64_t(p.sphereCount) + p.planeCount + p.largeSphereCount + p.boxCount + p.rectCount +
         p.diskCount + p.cylinderCount + p.ellipsoidCount;
}

// Shapes that every ray is tested against.
std::uint64_t listedShapes(const gpu::TraceParams& p) {
  const bool hierarchy = (p.flags & gpu::TRACE_SHAPE_HIERARCHY) != 0;
  return hierarchy ? std::uint64_t(p.planeCount) + p.largeSphereCount : shapes(p);
}

}  // namespace

std::uint64_t iterationsPerVertex(const gpu::TraceParams& params, std::uint32_t lightSamples,
                                  double traversalSteps) {
  // Every loop also counts its last, failing test; the generic variant makes that test of all loops.
  constexpr std::uint64_t loopsPerTraversal = 10;
  const std::uint64_t traversal = listedShapes(params) + loopsPerTraversal + std::uint64_t(traversalSteps);
  const bool sky = (params.flags & gpu::TRACE_ENVIRONMENT) != 0;
  const bool someLights = params.lightCount > lightSamples;
  const std::uint64_t choice = (someLights ? lightTreeDepth(params.lightCount) : 0) + 1;
  const std::uint64_t lights = lightSamples * (1 + choice + traversal) + 1;
  const std::uint64_t environment = environmentIterations + (sky ? traversal : loopsPerTraversal);
  const std::uint64_t metLights = choice + params.sunCount * (1 + choice) + 1;
  return 1 + traversal + lights + environment + metLights;
}

LoopPlan planLoops(const gpu::TraceParams& params, std::uint64_t budget, double traversalSteps,
                   double traversals) {
  const std::uint64_t vertices = params.maxBounces + ((params.flags & gpu::TRACE_MET_LIGHTS) != 0 ? 2 : 1);
  LoopPlan plan;
  plan.lightSamples = std::min(params.lightSamples, std::max(params.lightCount, 1u));
  while (plan.lightSamples > 1 &&
         iterationsPerVertex(params, plan.lightSamples, traversalSteps) * vertices > budget)
    plan.lightSamples -= 1;
  const std::uint64_t perSample = iterationsPerVertex(params, plan.lightSamples, traversalSteps) * vertices;
  // What a hierarchy needs is a guess on the safe side: a sample that runs out after all is counted as a
  // fault.
  if (iterationsPerVertex(params, 1) * vertices > budget) {
    const std::uint64_t fitting = budget / iterationsPerVertex(params, 1);
    throw Error(ExitCode::badInput,
                "This scene has " + std::to_string(shapes(params)) + " shapes; with " +
                    std::to_string(params.maxBounces) + " bounces one path needs " +
                    std::to_string(perSample) +
                    " loop iterations, this device's driver stops at 65,535. Set the bounces to " +
                    std::to_string(fitting > 0 ? fitting - 1 : 0) + " or less, hide shapes, or use a GPU.");
  }
  const std::uint64_t atWorst =
      iterationsPerVertex(params, plan.lightSamples, traversalSteps * traversals) * vertices;
  plan.samplesPerDispatch = std::uint32_t(std::clamp<std::uint64_t>(budget / atWorst, 1, 4096));
  return plan;
}

}  // namespace steradian
