// SPDX-License-Identifier: MIT
// Renders a scene many times and compares with a reference.
#pragma once
#include <functional>

#include "editor/report/report.hpp"

namespace steradian::report {

struct MeasureOptions {
  Extent film{256, 192};
  std::uint64_t maxSamples = 1024;  // a power of two
  double seconds = 60.0;            // of tracing for one scene, references included; fewer samples if need be
  int runs = 5;
  bool ablate = false;
  double warmUpSeconds = 0.0;  // of tracing before each run: a GPU that has been idle is slow at first
};

/// A reference has this many times the samples of the longest run, and another seed.
inline constexpr std::uint64_t kReferenceFactor = 64;

/// The largest power of two up to options.maxSamples whose `runs` runs of every variant and `references`
/// references fit into options.seconds, but never less than 8: below, no slope can be fitted.
std::uint64_t affordableSamples(const MeasureOptions& options, double secondsPerSample, int variants,
                                int references);

/// `doing` is a few words for people, `fraction` 0..1 of this scene.
using MeasureProgress = std::function<void(const std::string& doing, double fraction)>;

/// A variant that changes nothing in this scene is left out. SMAPE is of the picture as the scene displays
/// it, through `tonemapper`. On the renderer's thread; the renderer keeps its last variant. Throws what
/// Renderer throws.
SceneReport measureScene(Renderer& renderer, const Scene& scene, const CameraView& view,
                         const Tonemapper& tonemapper, const MeasureOptions& options,
                         const MeasureProgress& progress);

}  // namespace steradian::report
