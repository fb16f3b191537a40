// SPDX-License-Identifier: MIT
// The convergence loop.
#include "renderer/still.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "renderer/convergence.hpp"
#include "renderer/stopwatch.hpp"

namespace steradian {

namespace {

using Clock = std::chrono::steady_clock;

/// How far each condition has come, and when it will be met at the present pace.
class Conditions {
 public:
  Conditions(const StillRequest& request) : request_(request) {}

  StillProgress progress(const RenderStats& stats, double seconds, const ErrorEstimate& error) const {
    StillProgress now{stats.samples, seconds, 0.0, std::nullopt, error};
    const double samples = stats.samplesOnAverage;
    if (request_.spp) consider(now, samples, double(*request_.spp));
    if (request_.untilSeconds)
      considerSeconds(now, seconds / *request_.untilSeconds, *request_.untilSeconds - seconds);
    if (request_.untilRelRmse && error.valid && measuredAt_ > 0)
      consider(now, samples, samplesNeeded(measuredAt_, error, *request_.untilRelRmse));
    return now;
  }
  void measured(std::uint64_t samples) { measuredAt_ = samples; }

 private:
  static void considerSeconds(StillProgress& now, double fraction, double remaining) {
    now.fraction = std::clamp(std::max(now.fraction, fraction), 0.0, 1.0);
    now.remainingSeconds = std::max(0.0, std::min(now.remainingSeconds.value_or(remaining), remaining));
  }
  static void consider(StillProgress& now, double samples, double needed) {
    if (samples > 0.0 && needed > 0.0)
      considerSeconds(now, samples / needed, now.seconds * (needed - samples) / samples);
  }

  const StillRequest& request_;
  std::uint64_t measuredAt_ = 0;
};

void check(const StillRequest& request) {
  if (!request.spp && !request.untilRelRmse && !request.untilSeconds)
    throw Error(ExitCode::usage, "nothing says when the render is done; give samples, an error or a time");
  if (request.sampleBegin >= request.sampleEnd) throw Error(ExitCode::usage, "the range of samples is empty");
}

std::uint64_t lastSample(const StillRequest& request) {
  const std::uint64_t count = request.sampleEnd - request.sampleBegin;
  return request.sampleBegin + std::min(count, request.spp.value_or(count));
}

/// Until every row holds the same samples.
void finishPass(Renderer& renderer, double batchMs) {
  while (renderer.midPass() && renderer.trace(batchMs)) {
  }
}

}  // namespace

std::uint64_t nextMeasurement(std::uint64_t samples, const ErrorEstimate& last, double targetRelRmse) {
  if (samples < 2) return 2;
  const std::uint64_t atMost = samples * 2, atLeast = samples + std::max<std::uint64_t>(1, samples / 16);
  if (!last.valid || !(last.relRmse > 0.0)) return atMost;
  if (!(targetRelRmse > 0.0)) return atMost;
  const double needed = samplesNeeded(samples, last, targetRelRmse);
  if (!(needed < double(atMost))) return atMost;
  return std::clamp(std::uint64_t(std::ceil(needed)), atLeast, atMost);
}

StillResult renderStill(Renderer& renderer, const StillRequest& request, const StillCallbacks& callbacks) {
  check(request);
  const auto start = Clock::now();
  renderer.setSampleRange(request.sampleBegin, lastSample(request));
  StillResult result;
  ErrorEstimate error;
  Conditions conditions(request);
  std::uint64_t measureAt = 2;
  for (double budgetMs = std::min(15.0, request.batchMs);;
       budgetMs = std::min(budgetMs * 2.0, request.batchMs)) {
    // Trace a batch; where the error decides, no pass goes beyond the place at which it is measured next
    if (request.untilRelRmse)
      renderer.extendSamples(std::min(lastSample(request), request.sampleBegin + measureAt));
    const bool more = renderer.trace(budgetMs);
    const std::uint64_t samples = renderer.stats().samples;
    if (result.secondsToFirstPixel == 0.0) result.secondsToFirstPixel = secondsSince(start);

    // Measure at the doublings, for the slope, and as often as the decision needs
    if (samples >= measureAt) {
      error = renderer.measureError();
      conditions.measured(samples);
      measureAt = nextMeasurement(samples, error, request.untilRelRmse.value_or(0.0));
    }
    const double seconds = secondsSince(start);
    if (callbacks.progress) callbacks.progress(conditions.progress(renderer.stats(), seconds, error));

    // Stop at the first condition that is met
    const bool goodEnough = request.untilRelRmse && error.valid && error.relRmse <= *request.untilRelRmse;
    const bool late = request.untilSeconds && samples >= 1 && seconds >= *request.untilSeconds;
    const bool cancelled = callbacks.cancelled && callbacks.cancelled();
    if (!more || goodEnough || late || cancelled) {
      result.end = goodEnough  ? StillEnd::error
                   : !more     ? StillEnd::samples
                   : cancelled ? StillEnd::cancelled
                               : StillEnd::time;
      break;
    }
  }
  if (request.wholePasses) finishPass(renderer, request.batchMs);
  renderer.measureError();
  renderer.measureTails();
  result.stats = renderer.stats();
  result.seconds = secondsSince(start);
  return result;
}

}  // namespace steradian
