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

/// Milliseconds from an edit to the first picture that shows it, median of 20 edits.
double measureEdit(Renderer& renderer, const BenchScene& scene);

}  // namespace steradian::bench
