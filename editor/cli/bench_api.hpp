// SPDX-License-Identifier: MIT
// The same kernel through Vulkan, as an OpenGL compute program and as C++ through GLM: same scene, size,
// samples and seed.
#pragma once
#include "editor/cli/bench.hpp"

namespace steradian::bench {

struct ApiRow {
  std::string api;
  std::string runsOn;                    // device and driver
  std::string refused;                   // why there are no figures, or empty
  double msPerSample = 0.0;              // wall time of one sample for every pixel, median
  double mraysPerSecond = 0.0;           // closest + shadow, of the median run
  std::optional<double> compileSeconds;  // with empty caches; none: compiled with this program
  std::optional<double> relMse;  // of the mean radiance against Vulkan's: mean (a - b)^2 / (b^2 + 0.01)
  std::uint64_t nan = 0, faults = 0;
};

struct ApiBenchResult {
  std::string project;
  Extent size;
  int maxBounces = 0;
  std::uint64_t samples = 0;  // per pixel
  std::vector<ApiRow> rows;   // Vulkan's first
};

/// One project; throws Error when Vulkan cannot, what another API cannot stands in its row. `samples`: per
/// pixel and run; `options.runs` interleaved runs.
ApiBenchResult measureApis(const plugins::PluginHost& host, const std::filesystem::path& project,
                           const BenchOptions& options, std::uint64_t samples);

std::string textOf(const std::vector<ApiBenchResult>& results);
std::string jsonOf(const std::vector<ApiBenchResult>& results);

}  // namespace steradian::bench
