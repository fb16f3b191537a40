// SPDX-License-Identifier: MIT
// Slices, the decision when to stop, and the file at the end.
#include "editor/ui/still_job.hpp"

#include <algorithm>
#include <limits>

#include "editor/still_file.hpp"
#include "renderer/convergence.hpp"
#include "renderer/still.hpp"

namespace steradian::ui {

namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

}  // namespace

StillJob::StillJob(std::shared_ptr<gpu::Device> device, std::shared_ptr<SceneCache> cache, const Scene& scene,
                   const CameraView& view, const Tonemapper& tonemapper, StillSettings settings)
    : settings_(std::move(settings)),
      renderer_(std::move(device), std::move(cache)),
      seed_(scene.render.seed),
      sceneName_(scene.name) {
  Scene still = scene;
  still.render.width = settings_.size.width;
  still.render.height = settings_.size.height;
  if (settings_.byError) still.render.errorMeter = true;
  renderer_.setPatient(true);
  renderer_.setTonemapper(tonemapper);
  renderer_.setDisplay(still.display);
  renderer_.setScene(still, view, settings_.size);
  renderer_.setSampleRange(0, settings_.byError ? kNoLimit : std::uint64_t(settings_.samples));
}

StillJob::~StillJob() = default;

const RenderStats& StillJob::stats() const {
  return renderer_.stats();
}

double StillJob::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool StillJob::goodEnough() const {
  const ErrorEstimate& error = stats().error;
  return settings_.byError && error.valid && error.relRmse <= 0.01 * settings_.errorPercent;
}

void StillJob::measure() {
  renderer_.measureError();
  measuredAt_ = stats().samples;
  measureAt_ = nextMeasurement(measuredAt_, stats().error, 0.01 * settings_.errorPercent);
}

bool StillJob::advance(double budgetMs) {
  if (renderer_.awaitsSpecialization()) return false;  // a file does not depend on when a compiler is done
  if (settings_.byError) renderer_.extendSamples(measureAt_);
  const bool more = renderer_.trace(budgetMs);
  if (stats().samples >= measureAt_) measure();
  return !more || goodEnough();
}

double StillJob::fraction() const {
  const double samples = stats().samplesOnAverage;
  if (!settings_.byError) return std::clamp(samples / std::max(settings_.samples, 1), 0.0, 1.0);
  const ErrorEstimate& error = stats().error;
  if (!error.valid || !(error.relRmse > 0.0)) return 0.0;
  const double needed = samplesNeeded(measuredAt_, error, 0.01 * settings_.errorPercent);
  return std::clamp(samples / std::max(needed, 1.0), 0.0, 1.0);
}

std::optional<double> StillJob::remainingSeconds() const {
  const double done = fraction();
  if (done < 0.01) return std::nullopt;
  return seconds() * (1.0 - done) / done;
}

void StillJob::write(const plugins::PluginHost& plugins, const std::string& device) {
  renderer_.measureError();
  renderer_.measureTails();
  const bool partial = !goodEnough() && fraction() < 1.0;
  saveStill(plugins, renderer_, {sceneName_, device, seed_, 0, stats(), partial}, {settings_.path});
}

}  // namespace steradian::ui
