// SPDX-License-Identifier: MIT
// Adds samples to a film in dispatches bounded by time and by the loop budget.
#pragma once
#include "renderer/film.hpp"
#include "renderer/gpu/commands.hpp"
#include "renderer/gpu_scene.hpp"
#include "renderer/loop_budget.hpp"
#include "renderer/variants.hpp"

namespace steradian {

/// What one pixel sample costs, learned from the device's clock; a guess until the first dispatch.
class CostModel {
 public:
  explicit CostModel(bool cpuDevice) : msPerMegasample_(cpuDevice ? 60.0 : 1.0) {}
  double msPerMegasample() const { return msPerMegasample_; }
  void learn(double milliseconds, double pixelSamples);
  /// A new scene: what it will cost is guessed from its loop iterations per vertex, so that the first
  /// dispatch of a heavy one stays short.
  void expect(double iterationsPerVertex);

 private:
  double iterations_ = 60.0;
  double msPerMegasample_;
  bool learned_ = false;
};

struct TraceTotals {
  double milliseconds = 0.0;  // device time
  double pixelSamples = 0.0;
};

class Tracer {
 public:
  explicit Tracer(const gpu::Device& device);

  /// One dispatch on `film`, at most about `budgetMs`; sample indices stop at `sampleEnd`. False when none is
  /// left.
  bool step(Film& film, const gpu::ComputePass& pass, const GpuScene& scene, const LoopPlan& plan,
            std::uint64_t sampleEnd, double budgetMs);
  const CostModel& cost() const { return cost_; }
  void sceneChanged(double iterationsPerVertex) { cost_.expect(iterationsPerVertex); }
  TraceTotals totals;

 private:
  void beginPass(Film& film, const LoopPlan& plan, std::uint64_t sampleEnd, double budgetMs) const;
  int rowsWithin(const Film& film, double budgetMs) const;

  const gpu::Device& device_;
  gpu::Commands commands_;
  CostModel cost_;
};

}  // namespace steradian
