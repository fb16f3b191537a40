// SPDX-License-Identifier: MIT
// Runs of all APIs in turn, so that a machine that grows warm or busy treats them alike.
#include "editor/cli/bench_api.hpp"

#include "editor/cli/bench_scene.hpp"
#include "editor/cli/image_compare.hpp"
#include "renderer/apis/cpp_host.hpp"
#include "renderer/apis/opengl_host.hpp"
#include "renderer/stopwatch.hpp"

namespace steradian::bench {

namespace {

using apis::KernelHost;
using apis::KernelRun;

/// The renderer as it is, with the pipeline that it compiles for this scene.
class VulkanKernel {
 public:
  VulkanKernel(const std::shared_ptr<gpu::Device>& device, const BenchScene& scene) : renderer_(device) {
    renderer_.allowSpecialization(false);
    renderer_.setScene(scene.scene, scene.view, scene.film);
    const double before = compiled();
    renderer_.allowSpecialization(true);
    renderer_.waitForSpecialization();
    compileSeconds_ = compiled() - before;
  }

  double compileSeconds() const { return compileSeconds_; }

  KernelRun run(std::uint64_t samples) {
    constexpr double longestDispatch = 200.0;  // ms
    renderer_.setSampleRange(0, samples);
    const auto start = std::chrono::steady_clock::now();
    while (renderer_.trace(longestDispatch)) {
    }
    KernelRun run;
    run.seconds = secondsSince(start);
    renderer_.measureError();
    const RenderStats& stats = renderer_.stats();
    run.rays = stats.raysClosest + stats.raysShadow;
    run.nan = stats.nanSamples;
    run.faults = stats.faults;
    run.mean = renderer_.radiance();
    return run;
  }

 private:
  double compiled() {
    renderer_.setSampleRange(0, 1);
    renderer_.trace(1.0);
    return renderer_.stats().compileSeconds;
  }

  Renderer renderer_;
  double compileSeconds_ = 0.0;
};

/// One API's row in the making. An Error is its last word.
struct Candidate {
  ApiRow row;
  std::function<KernelRun()> run;
  std::vector<double> seconds, mraysPerSecond;
  Image mean;

  template <class Action>
  void attempt(const Action& action) {
    if (!row.refused.empty()) return;
    try {
      action();
    } catch (const Error& error) {
      row.refused = error.what();
    }
  }

  /// A GPU that has been idle, while a CPU had its turn, runs at a fraction of its clock at first.
  void warmUp() const {
    const auto start = std::chrono::steady_clock::now();
    while (secondsSince(start) < 0.7) run();
  }

  void runOnce() {
    KernelRun done = run();
    seconds.push_back(done.seconds);
    mraysPerSecond.push_back(double(done.rays) / done.seconds * 1e-6);
    row.nan = done.nan;
    row.faults = done.faults;
    mean = std::move(done.mean);
  }
};

Candidate peer(const char* api, const apis::KernelInput& input, std::uint64_t samples,
               const std::function<std::unique_ptr<KernelHost>()>& make) {
  Candidate out;
  out.row.api = api;
  out.attempt([&] {
    const std::shared_ptr<KernelHost> host = make();
    out.row.runsOn = host->runsOn();
    out.row.compileSeconds = host->compileSeconds();
    out.run = [host, &input, samples] { return apis::runKernel(*host, input, samples); };
  });
  return out;
}

ApiRow finished(const Candidate& candidate, const Candidate& vulkan, std::uint64_t samples) {
  ApiRow row = candidate.row;
  if (!row.refused.empty()) return row;
  row.msPerSample = median(candidate.seconds) * 1e3 / double(samples);
  row.mraysPerSecond = median(candidate.mraysPerSecond);
  if (&candidate != &vulkan) row.relMse = cli::differenceOf(candidate.mean, vulkan.mean).relMse;
  return row;
}

}  // namespace

ApiBenchResult measureApis(const plugins::PluginHost& host, const std::filesystem::path& project,
                           const BenchOptions& options, std::uint64_t samples) {
  const BenchScene scene = loadBenchScene(host, project, options);
  const auto device = openDevice({.device = options.device});
  const DeviceDescription description = describe(*device);
  const apis::KernelInput input = apis::kernelInput(scene.scene, scene.view, scene.film, *device);
  VulkanKernel vulkan(device, scene);

  std::vector<Candidate> candidates(1);
  candidates[0].row.api = "Vulkan";
  candidates[0].row.runsOn = description.name + ", " + description.driver;
  candidates[0].row.compileSeconds = vulkan.compileSeconds();
  candidates[0].run = [&] { return vulkan.run(samples); };
  candidates.push_back(
      peer("OpenGL", input, samples, [&] { return apis::makeOpenGlHost(input, description.type == "CPU"); }));
  candidates.push_back(peer("C++", input, samples, [&] { return apis::makeCppHost(input); }));
  const bool gpu = description.type != "CPU";
  for (int run = 0; run < options.runs; ++run)
    for (Candidate& candidate : candidates)
      candidate.attempt([&] {
        if (gpu && candidate.row.api != "C++") candidate.warmUp();
        candidate.runOnce();
      });

  ApiBenchResult result{project.string(), scene.film, scene.scene.render.maxBounces, samples, {}};
  for (const Candidate& candidate : candidates)
    result.rows.push_back(finished(candidate, candidates[0], samples));
  return result;
}

}  // namespace steradian::bench
