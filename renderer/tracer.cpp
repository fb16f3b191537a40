// SPDX-License-Identifier: MIT
#include "renderer/tracer.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/gpu/barriers.hpp"

namespace steradian {

using namespace gpu;

namespace {

constexpr double interactiveBudgetMs = 100.0;
constexpr int groupSize = 8;  // local size of path_trace.comp in x and y

std::uint32_t groups(int pixels) {
  return std::uint32_t((pixels + groupSize - 1) / groupSize);
}

}  // namespace

void CostModel::learn(double milliseconds, double pixelSamples) {
  const double measured = std::max(milliseconds, 1e-4) / (pixelSamples * 1e-6);
  msPerMegasample_ = learned_ ? 0.5 * (msPerMegasample_ + measured) : measured;
  learned_ = true;
}

void CostModel::expect(double iterationsPerVertex) {
  msPerMegasample_ *= iterationsPerVertex / iterations_;
  iterations_ = iterationsPerVertex;
  learned_ = false;
}

Tracer::Tracer(const Device& device)
    : device_(device), commands_(device, QueueKind::compute), cost_(device.description().type == "CPU") {}

void Tracer::beginPass(Film& film, const LoopPlan& plan, std::uint64_t sampleEnd, double budgetMs) const {
  FilmProgress& p = film.progress;
  const double perSample = cost_.msPerMegasample() * double(film.pixels()) * 1e-6;
  // Grow gently: never more than what is there already, so that early pictures come soon.
  // A pass of many samples keeps all lanes busy (16, 64 and 128 a pass take 1, .96 and .93 of the time on
  // lavapipe); what does not fit the budget is cut into bands of rows. From 128 samples on an eighth of what
  // is there: a picture that ends within a pass shows no seam then, and a part that is interrupted is soon
  // whole. Short budgets belong to a viewport, whose count of samples should keep moving.
  const std::uint64_t grown = std::max<std::uint64_t>(1, p.done - p.begin);
  const double fewest = budgetMs < interactiveBudgetMs ? 4.0 : 16.0;
  const double most = budgetMs < interactiveBudgetMs ? 4.0 : 128.0;
  const double several = std::clamp(0.125 * double(grown), fewest, most);
  const std::uint64_t wanted = std::uint64_t(std::max(several, budgetMs / perSample));
  const std::uint64_t count =
      std::min({wanted, grown, std::uint64_t(plan.samplesPerDispatch), sampleEnd - p.done});
  p.passEnd = p.done + count;
  p.rowsDone = 0;
}

int Tracer::rowsWithin(const Film& film, double budgetMs) const {
  const FilmProgress& p = film.progress;
  const double rowMs =
      cost_.msPerMegasample() * 1e-6 * double(film.extent().width) * double(p.passEnd - p.done);
  const int rows = int(std::min(1e6, budgetMs / rowMs)) / (2 * groupSize) * (2 * groupSize);
  return std::clamp(rows, 2 * groupSize, film.extent().height);
}

bool Tracer::step(Film& film, const ComputePass& pass, const GpuScene& scene, const LoopPlan& plan,
                  std::uint64_t sampleEnd, double budgetMs) {
  FilmProgress& p = film.progress;
  if (p.passEnd == p.done) {
    if (p.done >= sampleEnd) return false;
    beginPass(film, plan, sampleEnd, budgetMs);
  }
  TraceParams params = scene.params;
  params.width = std::uint32_t(film.extent().width);
  params.height = std::uint32_t(film.extent().height);
  params.lightSamples = plan.lightSamples;
  params.perFilmUnit = 1.0f / film.unit();
  params.rowBegin = std::uint32_t(p.rowsDone);
  const int rows = std::min(rowsWithin(film, budgetMs), film.extent().height - p.rowsDone);
  params.rowEnd = params.rowBegin + std::uint32_t(rows);
  const bool errorMeter = (params.flags & TRACE_ERROR_METER) != 0;
  const double ms = commands_.run([&](const auto& cmd) {
    computeToCompute(cmd);
    for (const int half : {0, 1}) {
      const HalfRange range = halfRange(p.done, p.passEnd, half, errorMeter);
      if (range.count() == 0) continue;
      TraceParams own = params;
      own.sampleBegin = range.begin;
      own.sampleEnd = range.end;
      own.flags |= half == 1 ? TRACE_HALF_B : 0u;
      pass.dispatch(cmd, film.halfBindings(half), own, groups(film.extent().width), groups(rows));
    }
  });
  const double pixelSamples = double(film.extent().width) * rows * double(p.passEnd - p.done);
  cost_.learn(ms, pixelSamples);
  totals.milliseconds += ms;
  totals.pixelSamples += pixelSamples;
  p.rowsDone += rows;
  if (p.rowsDone >= film.extent().height) {
    p.done = p.passEnd;
    p.rowsDone = 0;
  }
  return true;
}

}  // namespace steradian
