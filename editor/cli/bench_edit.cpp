// SPDX-License-Identifier: MIT
// Time from an edit to the first traced picture that shows it, as the editor traces it.
#include <chrono>

#include "editor/cli/bench.hpp"
#include "editor/cli/bench_scene.hpp"

namespace steradian::bench {

namespace {

constexpr double kFrameBudgetMs = 20.0;  // of the editor's frames
constexpr int kEdits = 20;

/// The scene with its first visible shape a little further on.
Scene nudged(Scene scene, double metres) {
  for (Object& object : scene.objects) {
    if (!object.visible || !std::holds_alternative<Geometry>(object.content)) continue;
    object.transform.translation.y += metres;
    break;
  }
  return scene;
}

}  // namespace

double measureEdit(Renderer& renderer, const BenchScene& scene) {
  std::vector<double> milliseconds;
  for (int edit = 1; edit <= kEdits; ++edit) {
    const Scene edited = nudged(scene.scene, 1e-3 * edit);
    const auto start = std::chrono::steady_clock::now();
    renderer.setScene(edited, scene.view, scene.film);
    renderer.tracePreviewing(kFrameBudgetMs);
    milliseconds.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    // The next edit comes while the picture converges.
    renderer.trace(kFrameBudgetMs);
  }
  return median(milliseconds);
}

}  // namespace steradian::bench
