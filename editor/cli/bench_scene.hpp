// SPDX-License-Identifier: MIT
// The scene of a bench as it is measured.
#pragma once
#include "editor/cli/bench.hpp"

namespace steradian::bench {

struct BenchScene {
  Scene scene;
  CameraView view;
  Extent film;
};

BenchScene loadBenchScene(const plugins::PluginHost& host, const std::filesystem::path& project,
                          const BenchOptions& options);

}  // namespace steradian::bench
