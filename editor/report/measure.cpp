// SPDX-License-Identifier: MIT
// Calibration, references, runs.
#include "editor/report/measure.hpp"

#include <algorithm>
#include <cmath>

#include "editor/cli/image_compare.hpp"
#include "editor/report/variants.hpp"

namespace steradian::report {

namespace {

constexpr double kBatchMs = 200.0;
constexpr double kCalibrationSeconds = 0.3;
constexpr std::uint64_t kFewestSamples = 8;
constexpr std::uint32_t kReferenceSeed = 0x5eed0001u;  // far from the seeds of the runs

struct Reference {
  Image picture, shown;            // scene-linear, and as the scene displays it
  double mse = 0.0, relMse = 0.0;  // of its own error
};

class Measurement {
 public:
  Measurement(Renderer& renderer, const Scene& scene, const CameraView& view, const MeasureOptions& options,
              const MeasureProgress& progress)
      : renderer_(renderer), scene_(scene), view_(view), options_(options), progress_(progress) {}

  SceneReport run() {
    const std::vector<const Variant*> variants = variantsThatMatter();
    const int references = 1 + int(std::count_if(variants.begin(), variants.end(),
                                                 [](const Variant* v) { return v->anotherPicture; }));
    const std::uint64_t samples = affordableSamples(options_, calibrated(), int(variants.size()), references);
    const std::uint64_t ofReference = samples * kReferenceFactor;
    planned_ = double(samples) * options_.runs * double(variants.size()) + double(ofReference) * references;

    const Reference shared = referenceOf(baseline(), ofReference);
    SceneReport report;
    report.film = options_.film;
    report.runs = options_.runs;
    report.referenceSamples = ofReference;
    report.referenceRelRmse = std::sqrt(shared.relMse);
    for (const Variant* variant : variants)
      report.curves.push_back(variant->anotherPicture
                                  ? curve(*variant, samples, referenceOf(*variant, ofReference))
                                  : curve(*variant, samples, shared));
    return report;
  }

 private:
  void start(const Variant& variant, std::uint32_t seed) {
    prepare(renderer_, variant, scene_, view_, options_.film, seed);
  }

  void warmUp(const Variant& variant) {
    if (options_.warmUpSeconds <= 0.0) return;
    start(variant, ~scene_.render.seed);
    while (renderer_.stats().traceSeconds < options_.warmUpSeconds && renderer_.trace(kBatchMs)) {
    }
  }

  /// Goes on to `samples` in all.
  void traceTo(std::uint64_t samples, const std::string& doing) {
    renderer_.extendSamples(samples);
    std::uint64_t before = renderer_.stats().samples;
    while (renderer_.trace(kBatchMs)) {
      traced_ += double(renderer_.stats().samples - before);
      before = renderer_.stats().samples;
      if (progress_) progress_(doing, planned_ > 0.0 ? std::min(traced_ / planned_, 1.0) : 0.0);
    }
  }

  Image picture(const Variant& variant, std::uint64_t samples) {
    start(variant, scene_.render.seed);
    traceTo(samples, "calibration");
    return renderer_.radiance();
  }

  std::vector<const Variant*> variantsThatMatter() {
    std::vector<const Variant*> matter{&baseline()};
    if (!options_.ablate) return matter;
    constexpr std::uint64_t kSamples = 4;
    const Image full = picture(baseline(), kSamples);
    for (const Variant& variant : ablations())
      if (variant.onlySpeed || picture(variant, kSamples) != full) matter.push_back(&variant);
    return matter;
  }

  /// Seconds per sample of the film, from a short run behind a first sample: on some drivers that one
  /// compiles.
  double calibrated() {
    start(baseline(), scene_.render.seed);
    traceTo(1, "calibration");
    const double first = renderer_.stats().traceSeconds;
    std::uint64_t samples = 2;
    for (; samples < options_.maxSamples; samples *= 2) {
      traceTo(samples, "calibration");
      if (renderer_.stats().traceSeconds - first >= kCalibrationSeconds) break;
    }
    traced_ = 0.0;
    const double more = double(std::max<std::uint64_t>(renderer_.stats().samples, 2) - 1);
    return (renderer_.stats().traceSeconds - first) / more;
  }

  Reference referenceOf(const Variant& variant, std::uint64_t samples) {
    Variant metered = variant;
    metered.settings = [&variant](RenderSettings& settings) {
      if (variant.settings) variant.settings(settings);
      settings.errorMeter = true;
    };
    start(metered, scene_.render.seed ^ kReferenceSeed);
    traceTo(samples, "reference");
    const ErrorEstimate error = renderer_.measureError();
    return {renderer_.radiance(), renderer_.displayed(), error.rmse * error.rmse,
            error.relRmse * error.relRmse};
  }

  Curve curve(const Variant& variant, std::uint64_t samples, const Reference& reference) {
    std::vector<std::vector<Sample>> runs;
    std::uint64_t nan = 0, faults = 0;
    for (int run = 0; run < options_.runs; ++run) {
      warmUp(variant);
      start(variant, scene_.render.seed + std::uint32_t(run));
      const std::string doing = variant.label + ", run " + std::to_string(run + 1);
      std::vector<Sample> points;
      for (std::uint64_t n = 1; n <= samples; n *= 2) {
        traceTo(n, doing);
        points.push_back(sampleAgainst(reference));
      }
      nan += renderer_.stats().nanSamples;
      faults += renderer_.stats().faults;
      runs.push_back(std::move(points));
    }
    Curve curve = curveOf(variant.id, variant.label, runs);
    curve.nan = nan;
    curve.faults = faults;
    return curve;
  }

  Sample sampleAgainst(const Reference& reference) {
    const ErrorEstimate estimate = renderer_.measureError();
    const RenderStats& stats = renderer_.stats();
    const cli::ImageDifference d = cli::differenceOf(renderer_.radiance(), reference.picture);
    constexpr cli::Encodings kDisplay{cli::Encoding::display, cli::Encoding::display};
    const cli::ImageDifference shown = cli::differenceOf(renderer_.displayed(), reference.shown, kDisplay);
    Sample sample{stats.samples, stats.traceSeconds, d.mse - reference.mse, d.relMse - reference.relMse,
                  shown.smapeDisplay};
    if (estimate.valid) {
      sample.estimatedMse = estimate.rmse * estimate.rmse;
      sample.estimatedRelMse = estimate.relRmse * estimate.relRmse;
    }
    return sample;
  }

  Renderer& renderer_;
  const Scene& scene_;
  const CameraView& view_;
  const MeasureOptions& options_;
  const MeasureProgress& progress_;
  double planned_ = 0.0, traced_ = 0.0;  // samples of the film
};

}  // namespace

std::uint64_t affordableSamples(const MeasureOptions& options, double secondsPerSample, int variants,
                                int references) {
  const double perSample =
      secondsPerSample * (double(variants) * options.runs + double(kReferenceFactor) * references);
  std::uint64_t samples = options.maxSamples;
  while (samples > kFewestSamples && double(samples) * perSample > options.seconds) samples /= 2;
  return samples;
}

SceneReport measureScene(Renderer& renderer, const Scene& scene, const CameraView& view,
                         const Tonemapper& tonemapper, const MeasureOptions& options,
                         const MeasureProgress& progress) {
  renderer.setTonemapper(tonemapper);
  renderer.setDisplay(scene.display);
  return Measurement(renderer, scene, view, options, progress).run();
}

}  // namespace steradian::report
