// SPDX-License-Identifier: MIT
// Drivers that end loops silently after 65,535 iterations must never be given more.
#include "renderer/loop_budget.hpp"

#include <gtest/gtest.h>

namespace steradian {
namespace {

constexpr std::uint64_t driverLimit = 65'535;

gpu::TraceParams worstScene(unsigned shapes, unsigned lights, unsigned lightSamples, unsigned bounces) {
  gpu::TraceParams p{};
  p.sphereCount = shapes / 2;
  p.ellipsoidCount = shapes - shapes / 2;
  p.lightCount = lights;
  p.lightSamples = lightSamples;
  p.maxBounces = bounces;
  return p;
}

/// Counted from path_trace.comp by hand: turns of the outer loop, per turn one traversal and one per light
/// sample; each of the eight kinds' loops, the light loop and the outer loop test once more than they run.
std::uint64_t iterationsOfADispatch(const gpu::TraceParams& p, const LoopPlan& plan) {
  const std::uint64_t shapes = p.sphereCount + p.ellipsoidCount, traversal = shapes + 8;
  const std::uint64_t turn = 1 + traversal + plan.lightSamples * (1 + traversal) + 1;
  return turn * (p.maxBounces + 1) * plan.samplesPerDispatch;
}

TEST(LoopBudget, Row16NoPlannedDispatchReachesTheDriversLimit) {
  int planned = 0, refused = 0;
  for (const unsigned shapes : {1u, 10u, 100u, 300u, 1000u, 5000u, 20000u})
    for (const unsigned lights : {0u, 1u, 7u, 500u})
      for (const unsigned samples : {1u, 8u, 16u})
        for (const unsigned bounces : {0u, 1u, 8u, 64u}) {
          const gpu::TraceParams p = worstScene(shapes, lights, samples, bounces);
          try {
            const LoopPlan plan = planLoops(p, cpuDriverLoopBudget);
            ++planned;
            EXPECT_GE(plan.samplesPerDispatch, 1u);
            EXPECT_LE(plan.lightSamples, samples);
            EXPECT_LE(iterationsOfADispatch(p, plan), cpuDriverLoopBudget);
          } catch (const Error& error) {
            ++refused;
            EXPECT_EQ(error.code(), ExitCode::badInput);
            EXPECT_GT(iterationsOfADispatch(p, {1, 1}), cpuDriverLoopBudget);
          }
        }
  EXPECT_LT(cpuDriverLoopBudget, driverLimit);
  EXPECT_GT(planned, 200);
  EXPECT_GT(refused, 20);
}

TEST(LoopBudget, Row16TheAdvisedNumberOfBouncesFits) {
  const gpu::TraceParams asked = worstScene(1000, 4, 8, 64);
  std::string message;
  try {
    planLoops(asked, cpuDriverLoopBudget);
  } catch (const Error& error) {
    message = error.what();
  }
  const std::string before = "Set the bounces to ";
  const std::size_t found = message.find(before);
  ASSERT_NE(found, std::string::npos) << message;
  gpu::TraceParams advised = asked;
  advised.maxBounces = std::uint32_t(std::stoul(message.substr(found + before.size())));
  EXPECT_NO_THROW(planLoops(advised, cpuDriverLoopBudget));
  advised.maxBounces += 1;
  EXPECT_THROW(planLoops(advised, cpuDriverLoopBudget), Error);
}

TEST(LoopBudget, FewerLightsAreSampledBeforeASceneIsRefused) {
  const LoopPlan plan = planLoops(worstScene(300, 100, 16, 64), cpuDriverLoopBudget);
  EXPECT_LT(plan.lightSamples, 16u);
  EXPECT_GE(plan.lightSamples, 1u);
  EXPECT_EQ(planLoops(worstScene(300, 100, 16, 64), gpuLoopBudget).lightSamples, 16u);
}

}  // namespace
}  // namespace steradian
