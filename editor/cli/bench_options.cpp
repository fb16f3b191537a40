// SPDX-License-Identifier: MIT
// Reads the options of the bench and runs it.
#include "editor/cli/bench_options.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "editor/cli/arguments.hpp"
#include "editor/cli/bench.hpp"
#include "editor/cli/bench_api.hpp"
#include "editor/cli/bench_cache.hpp"
#include "editor/cli/bench_mesh.hpp"
#include "plugins/host/atomic_file.hpp"

namespace steradian::bench {

namespace {

struct Arguments {
  BenchOptions options;
  std::string size;
  std::filesystem::path firstPixel, plot;
  bool json = false, skipFirstPixel = false, noTargets = false;
  bool apis = false;
  std::uint64_t apiSamples = 16;  // per pixel and run
  bool meshes = false, ifIf = false, whileWhile = false;
  MeshBenchOptions meshOptions;
};

int runMeshBench(const Arguments& arguments) {
  MeshBenchOptions options = arguments.meshOptions;
  options.device = arguments.options.device;
  options.runs = arguments.options.runs;
  if (arguments.ifIf) options.whileWhile = false;
  if (arguments.whileWhile) options.whileWhile = true;
  if (!arguments.size.empty()) options.side = cli::parseSize(arguments.size).width / 8 * 8;
  const MeshBench bench = measureMeshes(options);
  std::fputs((arguments.json ? jsonOf(bench) : textOf(bench)).c_str(), stdout);
  if (!arguments.plot.empty()) plugins::writeFileAtomically(arguments.plot, plotOf(bench));
  return 0;
}

int runApiBench(const Arguments& arguments) {
  BenchOptions options = arguments.options;
  if (options.projects.empty()) options.projects = {"projects/thesis-room", "projects/cornell"};
  const CacheFolder caches;  // so that compiling counts in full
  caches.use();
  const plugins::PluginHost host(plugins::defaultSearchPath(options.pluginPath));
  std::vector<ApiBenchResult> results;
  for (const auto& project : options.projects)
    results.push_back(measureApis(host, project, options, arguments.apiSamples));
  std::fputs((arguments.json ? jsonOf(results) : textOf(results)).c_str(), stdout);
  return 0;
}

int runBench(Arguments arguments, const std::vector<std::string>& self) {
  BenchOptions& options = arguments.options;
  if (!arguments.size.empty()) options.size = cli::parseSize(arguments.size);
  if (!arguments.firstPixel.empty()) {
    renderFirstPixel(arguments.firstPixel, options);
    return 0;
  }
  if (arguments.meshes) return runMeshBench(arguments);
  if (arguments.apis) return runApiBench(arguments);
  if (options.projects.empty())
    throw Error(ExitCode::usage,
                "bench: name at least one project, e.g. steradian bench projects/thesis-room");
  if (!arguments.skipFirstPixel) options.firstPixelCommand = self;
  if (arguments.noTargets) options.targets.clear();
  const plugins::PluginHost host(plugins::defaultSearchPath(options.pluginPath));
  std::vector<BenchResult> results;
  for (const auto& project : options.projects)
    results.push_back(measure(host, project, options,
                              [](const std::string& step) { std::fprintf(stderr, "%s\n", step.c_str()); }));
  std::fputs((arguments.json ? jsonOf(results) : textOf(results)).c_str(), stdout);
  return 0;
}

}  // namespace

std::function<int()> addBenchOptions(CLI::App& command, const std::vector<std::string>& self) {
  auto arguments = std::make_shared<Arguments>();
  BenchOptions& o = arguments->options;
  command.add_option("projects", o.projects, "Projects to measure");
  command.add_option("--device", o.device, "Vulkan device by index or part of its name");
  command.add_option("--size", arguments->size, "Width and height in pixels instead of the project's");
  command.add_option("--bounces", o.bounces, "Bounce limit instead of the project's")
      ->check(CLI::Range(0, 64));
  command.add_option("--runs", o.runs, "Interleaved runs, of which the median is reported")
      ->check(CLI::Range(1, 1000));
  command.add_option("--seconds", o.secondsPerRun, "Tracing time of one run")->check(cli::aboveZero);
  command.add_option("--target", o.targets, "Relative RMSE to reach, e.g. 0.01; repeatable")
      ->check(cli::aboveZero)
      ->allow_extra_args(false);
  command.add_flag("--no-target", arguments->noTargets, "Do not measure the time to an error");
  command.add_option("--limit", o.targetSecondsLimit, "Longest time to an error, seconds")
      ->check(cli::aboveZero);
  command.add_flag("--no-first-pixel", arguments->skipFirstPixel,
                   "Do not measure the time to the first pixel");
  command.add_option("--first-pixel", arguments->firstPixel)->group("");  // how the bench starts itself
  command.add_option("--plugin-path", o.pluginPath, "Further folder with plugins; repeatable")
      ->allow_extra_args(false);
  command.add_flag("--json", arguments->json, "Machine-readable output");
  command.add_flag("--api", arguments->apis,
                   "Run the same kernel through Vulkan, OpenGL and C++ instead, and compare");
  command.add_option("--spp", arguments->apiSamples, "With --api: samples per pixel of one run")
      ->check(CLI::Range(1, 1'000'000));
  command.add_flag("--mesh", arguments->meshes,
                   "Measure rays through triangle meshes instead, beside Embree");
  command
      .add_option("--triangles", arguments->meshOptions.triangles, "With --mesh: sizes, e.g. 1000,10000000")
      ->delimiter(',')
      ->check(CLI::Range(100, 40'000'000));
  command.add_option("--threads", arguments->meshOptions.threads, "With --mesh: of Embree and of the builds")
      ->check(CLI::Range(1, 256));
  command.add_option("--plot", arguments->plot,
                     "With --mesh: an SVG file for time per ray against triangles");
  command.add_flag("--if-if", arguments->ifIf, "With --mesh: one loop for nodes and triangles, as on GPUs");
  command.add_flag("--while-while", arguments->whileWhile, "With --mesh: a loop for each, as on CPU drivers")
      ->excludes("--if-if");
  return [arguments, self] { return runBench(*arguments, self); };
}

}  // namespace steradian::bench
