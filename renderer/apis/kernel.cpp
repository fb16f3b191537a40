// SPDX-License-Identifier: MIT
// Dispatches as the tracer plans them, and the picture from the sums.
#include "renderer/apis/kernel.hpp"

#include <algorithm>

#include "renderer/film.hpp"
#include "renderer/loop_budget.hpp"
#include "renderer/stopwatch.hpp"
#include "renderer/variants.hpp"

namespace steradian::apis {
namespace {

constexpr double longestDispatch = 0.2;  // seconds: a GPU that also draws a desktop stops long ones

/// How many samples come next: never more than are there already, what the loop budget and the time allow.
std::uint64_t nextCount(std::uint64_t done, std::uint64_t samples, const LoopPlan& plan, double seconds) {
  const double perSample = seconds / double(std::max<std::uint64_t>(done, 1));
  const double fitting = perSample > 0.0 ? std::max(1.0, longestDispatch / perSample) : 1.0;
  const std::uint64_t most =
      std::min<std::uint64_t>(plan.samplesPerDispatch, std::max<std::uint64_t>(done, 1));
  return std::min({most, std::uint64_t(std::min(fitting, 4096.0)), samples - done});
}

void addSamples(KernelHost& host, gpu::TraceParams params, std::uint64_t begin, std::uint64_t end) {
  const bool errorMeter = (params.flags & gpu::TRACE_ERROR_METER) != 0;
  for (const int half : {0, 1}) {
    const HalfRange range = halfRange(begin, end, half, errorMeter);
    if (range.count() == 0) continue;
    gpu::TraceParams own = params;
    own.rowEnd = params.height;
    own.sampleBegin = range.begin;
    own.sampleEnd = range.end;
    own.flags |= half == 1 ? gpu::TRACE_HALF_B : 0u;
    host.dispatch(own);
  }
}

KernelRun summed(const KernelSums& sums, Extent film, double unit, std::uint64_t samples) {
  constexpr double perBase = 1.0 / gpu::FILM_BASE;
  KernelRun run;
  run.nan = sums.counters[gpu::COUNTER_NAN];
  run.faults = sums.counters[gpu::COUNTER_FAULTS];
  run.mean = {film.width, film.height, 3, std::vector<float>(std::size_t(film.width) * film.height * 3)};
  for (std::size_t i = 0; i < std::size_t(film.width) * film.height; ++i) {
    glm::dvec3 total(0.0);
    for (const auto& [low, middle, high] : sums.digits) {
      total +=
          (glm::dvec3(high[i]) + (glm::dvec3(middle[i]) + glm::dvec3(low[i]) * perBase) * perBase) * unit;
      run.rays += std::uint32_t(low[i].w) + std::uint64_t(std::uint32_t(middle[i].w));
    }
    for (int c = 0; c < 3; ++c) run.mean.pixels[i * 3 + c] = float(total[c] / double(samples));
  }
  return run;
}

}  // namespace

KernelInput kernelInput(const Scene& scene, const CameraView& view, Extent film, const gpu::Device& device) {
  KernelInput input{reference::tracedScene(packScene(scene, view, film), device), {}, film};
  const GpuScene& packed = input.traced.scene;
  for (const gpu::Specialization& constant :
       constantsOf(device, variantFor(packed, packed.params.lightSamples))) {
    input.constants.resize(std::max<std::size_t>(input.constants.size(), constant.id + 1u));
    input.constants[constant.id] = constant.value;
  }
  return input;
}

KernelRun runKernel(KernelHost& host, const KernelInput& input, std::uint64_t samples) {
  const GpuScene& scene = input.traced.scene;
  const LoopPlan plan = planLoops(scene.params, host.loopBudget(), scene.traversalSteps, scene.traversals);
  gpu::TraceParams params = scene.params;
  params.perFilmUnit = 1.0f / scene.filmUnit;
  host.clear();
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t done = 0; done < samples;) {
    const std::uint64_t count = nextCount(done, samples, plan, secondsSince(start));
    addSamples(host, params, done, done + count);
    done += count;
  }
  const double seconds = secondsSince(start);
  KernelRun run = summed(host.read(), input.film, scene.filmUnit, samples);
  run.seconds = seconds;
  return run;
}

}  // namespace steradian::apis
