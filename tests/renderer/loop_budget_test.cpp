// SPDX-License-Identifier: MIT
// Drivers that end loops silently after 65,535 iterations must never be given more.
#include "renderer/loop_budget.hpp"

#include <gtest/gtest.h>

#include "renderer/light_tree.hpp"
#include "tests/measured.hpp"

namespace steradian {
namespace {

constexpr std::uint64_t plannedBelow = 60'000, driverLimit = 65'535;

gpu::TraceParams worstScene(unsigned shapes, unsigned lights, unsigned lightSamples, unsigned bounces) {
  gpu::TraceParams p{};
  p.sphereCount = shapes / 2;
  p.ellipsoidCount = shapes - shapes / 2;
  p.lightCount = lights;
  p.lightSamples = lightSamples;
  p.maxBounces = bounces;
  p.sunCount = lights / 100;
  p.flags = lights > 7 ? gpu::TRACE_ENVIRONMENT : 0u;
  return p;
}

/// Counted from path_trace.comp by hand. Every loop tests once more than it runs: the eight kinds' of a
/// traversal, the lights', the suns', the bisections of an environment (34 in all), and the light tree's,
/// which runs for each light sample, for a light that was met and for each sun.
std::uint64_t iterationsOfADispatch(const gpu::TraceParams& p, const LoopPlan& plan) {
  const std::uint64_t shapes = p.sphereCount + p.ellipsoidCount, traversal = shapes + 8;
  const std::uint64_t tree = (p.lightCount > plan.lightSamples ? lightTreeDepth(p.lightCount) : 0) + 1;
  const std::uint64_t sky = 34 + (p.flags & gpu::TRACE_ENVIRONMENT ? traversal : 8);
  const std::uint64_t sunLoop = p.sunCount * (1 + tree) + 1;
  const std::uint64_t turn =
      1 + traversal + plan.lightSamples * (1 + tree + traversal) + 1 + sky + tree + sunLoop;
  return turn * (p.maxBounces + 1) * plan.samplesPerDispatch;
}

TEST(LoopBudget, row16_no_planned_dispatch_reaches_the_drivers_limit) {
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
            EXPECT_LT(iterationsOfADispatch(p, plan), plannedBelow);
            measured("loop iterations of an invocation", double(iterationsOfADispatch(p, plan)),
                     double(plannedBelow - 1));
          } catch (const Error& error) {
            ++refused;
            EXPECT_EQ(error.code(), ExitCode::badInput);
            EXPECT_GE(iterationsOfADispatch(p, {1, 1}), plannedBelow);
          }
        }
  static_assert(cpuDriverLoopBudget < plannedBelow && plannedBelow < driverLimit);
  EXPECT_GT(planned, 200);
  EXPECT_GT(refused, 20);
}

TEST(LoopBudget, row16_the_advised_number_of_bounces_fits) {
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
  const std::uint64_t iterations = iterationsOfADispatch(advised, planLoops(advised, cpuDriverLoopBudget));
  EXPECT_LT(iterations, plannedBelow);
  measured("loop iterations of an invocation", double(iterations), double(plannedBelow - 1));
  advised.maxBounces += 1;
  EXPECT_THROW(planLoops(advised, cpuDriverLoopBudget), Error);
}

TEST(LoopBudget, ShapesInTheHierarchyCountByTheStepsOfARay) {
  gpu::TraceParams p = worstScene(20000, 4, 4, 8);
  EXPECT_THROW(planLoops(p, cpuDriverLoopBudget), Error);
  p.flags |= gpu::TRACE_SHAPE_HIERARCHY;
  p.planeCount = 10;
  EXPECT_EQ(planLoops(p, cpuDriverLoopBudget, 150.0).lightSamples, 4u);
  EXPECT_GE(iterationsPerVertex(p, 4, 150.0), 5u * (150u + 10u));
}

TEST(LoopBudget, FewerLightsAreSampledBeforeASceneIsRefused) {
  const LoopPlan plan = planLoops(worstScene(200, 100, 16, 64), cpuDriverLoopBudget);
  EXPECT_LT(plan.lightSamples, 16u);
  EXPECT_GE(plan.lightSamples, 1u);
  EXPECT_EQ(planLoops(worstScene(200, 100, 16, 64), gpuLoopBudget).lightSamples, 16u);
}

}  // namespace
}  // namespace steradian
