// SPDX-License-Identifier: MIT
// The measurements of one project.
#include "editor/cli/bench.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include "editor/cli/bench_scene.hpp"
#include "editor/cli/yardstick.hpp"
#include "renderer/still.hpp"

namespace steradian::bench {

namespace {

/// A renderer with the scene on it, and what its runs gave.
struct Variant {
  Renderer renderer;
  bool onCpu;
  std::vector<double> msPerSample, mraysPerSecond, operationsPerRay;

  Variant(const std::shared_ptr<gpu::Device>& device, const BenchScene& scene, bool special)
      : renderer(device), onCpu(describe(*device).type == "CPU") {
    renderer.allowSpecialization(special);
    renderer.setScene(scene.scene, scene.view, scene.film);
    if (special) renderer.waitForSpecialization();
  }

  void run(std::uint64_t samples) {
    StillRequest request;
    request.spp = samples;
    const double before = onCpu ? vectorGflops() : 0.0;
    const StillResult result = renderStill(renderer, request);
    msPerSample.push_back(result.seconds * 1e3 / double(result.stats.samples));
    mraysPerSecond.push_back(double(result.stats.raysClosest + result.stats.raysShadow) /
                             result.stats.traceSeconds * 1e-6);
    if (onCpu)
      operationsPerRay.push_back(
          peakOperationsPerRay(0.5 * (before + vectorGflops()), mraysPerSecond.back()));
  }
  Throughput throughput() const {
    return {median(msPerSample), median(mraysPerSecond),
            onCpu ? std::optional(median(operationsPerRay)) : std::nullopt, renderer.stats().variant};
  }
};

/// How many samples fill the time of one run.
std::uint64_t samplesPerRun(Variant& variant, double seconds) {
  StillRequest request;
  request.untilSeconds = seconds * 0.5;
  const StillResult result = renderStill(variant.renderer, request);
  return std::max<std::uint64_t>(1, std::uint64_t(double(result.stats.samples) * seconds / result.seconds));
}

Image picture(Variant& variant, std::uint64_t samples) {
  StillRequest request;
  request.spp = samples;
  renderStill(variant.renderer, request);
  return variant.renderer.radiance();
}

TimeToError timeTo(Variant& variant, double target, const BenchOptions& options) {
  constexpr double kOnceIsEnough = 20.0;  // seconds: long runs differ little and cost much
  TimeToError out{target, std::nullopt, 0};
  std::vector<double> seconds;
  for (int run = 0; run < options.runs; ++run) {
    StillRequest request;
    request.untilRelRmse = target;
    request.untilSeconds = options.targetSecondsLimit;
    const StillResult result = renderStill(variant.renderer, request);
    out.samples = result.stats.samples;
    if (result.end != StillEnd::error) return out;
    seconds.push_back(result.seconds);
    if (result.seconds > kOnceIsEnough) break;
  }
  out.seconds = median(seconds);
  return out;
}

}  // namespace

double median(std::vector<double> values) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

BenchResult measure(const plugins::PluginHost& host, const std::filesystem::path& project,
                    const BenchOptions& options, const std::function<void(const std::string&)>& note) {
  const auto say = [&](const std::string& step) {
    if (note) note(project.string() + ": " + step);
  };
  BenchResult result;
  result.project = project.string();
  if (!options.firstPixelCommand.empty()) {
    say("first pixel");
    const FirstPixel first = measureFirstPixel(project, options);
    result.coldFirstPixel = first.cold;
    result.warmFirstPixel = first.warm;
  }

  const BenchScene scene = loadBenchScene(host, project, options);
  const auto device = openDevice({.device = options.device});
  result.device = describe(*device);
  result.size = scene.film;
  result.maxBounces = scene.scene.render.maxBounces;
  Variant generic(device, scene, false), special(device, scene, true);

  // Interleaved, so that a machine that grows warm or busy treats both alike
  const std::uint64_t samples = samplesPerRun(special, options.secondsPerRun);
  for (int run = 0; run < options.runs; ++run) {
    say("run " + std::to_string(run + 1) + " of " + std::to_string(options.runs));
    generic.run(samples);
    special.run(samples);
  }
  result.generic = generic.throughput();
  result.special = special.throughput();

  say("generic and special image");
  const std::uint64_t few = std::min<std::uint64_t>(samples, 8);
  result.bitEqual = picture(generic, few) == picture(special, few);

  for (const double target : scene.scene.render.errorMeter ? options.targets : std::vector<double>{}) {
    say("time to " + std::to_string(target * 100.0) + " %");
    result.timeToError.push_back(timeTo(special, target, options));
  }
  result.nan = special.renderer.stats().nanSamples;
  result.faults = special.renderer.stats().faults;
  result.editMs = measureEdit(special.renderer, scene);
  result.validationMessages = validationMessages(*device);
  return result;
}

}  // namespace steradian::bench
