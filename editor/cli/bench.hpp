// SPDX-License-Identifier: MIT
// Measures the renderer: time per sample, rays per second, first pixel, time to an error, generic against
// special. Needs the renderer and the plugin host only, so it also runs on a bare GPU machine.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plugins/host/plugin_host.hpp"
#include "renderer/renderer.hpp"

namespace steradian::bench {

struct BenchOptions {
  std::vector<std::filesystem::path> projects;
  std::string device;
  std::optional<Extent> size;               // else the project's
  std::optional<int> bounces;               // else the project's
  int runs = 5;                             // interleaved; medians are reported
  double secondsPerRun = 2.0;               // of tracing, per variant
  std::vector<double> targets{0.05, 0.01};  // relative RMSE to reach
  double targetSecondsLimit = 300.0;        // per target; beyond it the figure is absent
  std::vector<std::filesystem::path> pluginPath;
  /// How to start this program so that it prints the seconds to its first pixel; empty = not measured.
  std::vector<std::string> firstPixelCommand;
};

struct Throughput {
  double msPerSample = 0.0;     // wall time of one sample for every pixel, all measuring in it, median
  double mraysPerSecond = 0.0;  // closest + shadow by the time of their dispatches, median
  /// On a CPU device, median: what the vector units gave around each run, in that time (yardstick.hpp).
  std::optional<double> operationsPerRay;
  VariantInfo variant;
};

struct TimeToError {
  double relRmse = 0.0;
  std::optional<double> seconds;  // wall, median; absent: the limit came first
  std::uint64_t samples = 0;
};

struct BenchResult {
  std::string project;
  DeviceDescription device;
  Extent size;
  int maxBounces = 0;
  Throughput generic, special;
  bool bitEqual = false;                                 // images of both variants, same samples
  std::optional<double> coldFirstPixel, warmFirstPixel;  // seconds from process start, medians
  std::vector<TimeToError> timeToError;                  // special variant
  double editMs = 0.0;  // from an edit to a traced picture that shows it, median
  std::uint64_t nan = 0, faults = 0;
  int validationMessages = 0;
};

double median(std::vector<double> values);  // of at least one value

/// One project; throws Error. `note` gets a line per step, may be empty.
BenchResult measure(const plugins::PluginHost& host, const std::filesystem::path& project,
                    const BenchOptions& options, const std::function<void(const std::string&)>& note);

/// Cold: every cache folder (ours, Mesa's, NVIDIA's) empty; warm: the second start with the same folders.
struct FirstPixel {
  double cold = 0.0, warm = 0.0;  // seconds
};
FirstPixel measureFirstPixel(const std::filesystem::path& project, const BenchOptions& options);
/// What the started program does: loads `project` and traces until something can be seen.
void renderFirstPixel(const std::filesystem::path& project, const BenchOptions& options);

std::string textOf(const std::vector<BenchResult>& results);
std::string jsonOf(const std::vector<BenchResult>& results);

}  // namespace steradian::bench
