// SPDX-License-Identifier: MIT
// Keeping the picture up to date.
#include "editor/ui/live_render.hpp"

#include <algorithm>

#include "editor/tonemapping.hpp"

namespace steradian::ui {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kMeasureInterval{600};
constexpr std::size_t kTailPixels = 1 << 16;  // read back in one frame: a millisecond or two
constexpr double kLongestStep = 0.5;          // seconds between calls that count as work; more were a pause

}  // namespace

LiveRender::LiveRender(std::shared_ptr<gpu::Device> device, std::shared_ptr<SceneCache> cache,
                       const plugins::PluginHost& plugins, Messages& messages)
    : renderer_(std::move(device), std::move(cache)), plugins_(plugins), messages_(messages) {
  renderer_.setPatient(true);
}

void LiveRender::showDisplay(const DisplaySettings& display) {
  if (display_ == display) return;
  display_ = display;
  try {
    renderer_.setDisplay(display);
    renderer_.setTonemapper(tonemapperFor(plugins_, display));
  } catch (const Error& error) {
    messages_.error(error.what());
  }
}

void LiveRender::show(const Snapshot& scene, const CameraView& view, Extent film) {
  if (film.width < 1 || film.height < 1 || lost_) return;
  showDisplay(scene->display);
  if (scene == scene_ && view == view_ && film == film_) return;
  scene_ = scene;
  view_ = view;
  film_ = film;
  try {
    renderer_.setScene(*scene, view, film);
  } catch (const std::bad_alloc&) {
    messages_.error("Not enough memory to show the scene; the last picture stays.");
  } catch (const Error& error) {
    messages_.error(error.what());
  }
  if (renderer_.stats().samples > 0) return;
  measuredAt_ = tailsAt_ = 0;
  seconds_ = 0.0;
}

bool LiveRender::resting(std::uint64_t sampleLimit) const {
  return lost_ || (sampleLimit > 0 && renderer_.stats().samples >= sampleLimit);
}

void LiveRender::keepPace() {
  const auto now = Clock::now();
  const double step = std::chrono::duration<double>(now - steppedTime_).count();
  steppedTime_ = now;
  if (step < kLongestStep) seconds_ += step;
}

double LiveRender::secondsPerSample() const {
  const std::uint64_t samples = renderer_.stats().samples;
  return samples > 0 ? seconds_ / double(samples) : 0.0;
}

void LiveRender::measureWhenDue(bool last) {
  const std::uint64_t samples = renderer_.stats().samples;
  if (samples < measuredAt_) measuredAt_ = tailsAt_ = 0;  // it started over
  const bool grown = samples >= 2 && samples >= measuredAt_ + measuredAt_ / 16 + 1;
  // The slope needs every doubling, people a fresh figure now and then; without the meter there are only
  // counters.
  const bool later = scene_->render.errorMeter && Clock::now() - measuredTime_ >= kMeasureInterval;
  const bool enough = samples >= 2 * measuredAt_ || later;
  const bool due = last ? samples > measuredAt_ : grown && enough;
  if (due) {
    renderer_.measureError();
    measuredAt_ = samples;
    measuredTime_ = Clock::now();
  }
  // The film is read back for the tails: as seldom as the slope gets a point, and in slices.
  if (measuredAt_ >= 2 * std::max<std::uint64_t>(tailsAt_, 1) || (last && measuredAt_ > tailsAt_)) {
    measuringTails_ = true;
    tailsAt_ = measuredAt_;
  }
  if (measuringTails_) measuringTails_ = !renderer_.measureTails(kTailPixels);
}

void LiveRender::advance(double budgetMs, std::uint64_t sampleLimit) {
  if (!scene_ || lost_) return;
  try {
    const bool last = resting(sampleLimit);
    if (!last) {
      renderer_.tracePreviewing(budgetMs);
      keepPace();
    }
    measureWhenDue(last);
  } catch (const Error& error) {
    lost_ = true;
    messages_.error(std::string(error.what()) + " The picture stands still; save your work and restart.");
  }
}

std::optional<PickResult> LiveRender::pick(int x, int y) {
  if (!scene_ || lost_) return std::nullopt;
  return renderer_.pick(x, y);
}

}  // namespace steradian::ui
