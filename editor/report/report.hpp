// SPDX-License-Identifier: MIT
// Error against time: what was measured, and what it says.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "editor/report/statistics.hpp"
#include "renderer/renderer.hpp"

namespace steradian::report {

/// The relative RMSE whose time is reported.
inline constexpr double kTarget = 0.01;

/// One run at one sample count, against the reference, whose own error is taken off the squares.
struct Sample {
  std::uint64_t samples = 0;
  double seconds = 0.0;  // of tracing
  double mse = 0.0, relMse = 0.0, smapeDisplay = 0.0;
  double estimatedMse = 0.0, estimatedRelMse = 0.0;  // what the error meter said; 0 without it
};

/// All runs at one sample count.
struct CurvePoint {
  std::uint64_t samples = 0;
  Spread seconds, rmse, relRmse, smapeDisplay;
  // Estimated / true, root mean squares over the runs; 0 without the meter.
  double meterRatio = 0.0, relMeterRatio = 0.0;
};

struct Curve {
  std::string id, label;  // "no-roulette", "no Russian roulette"
  std::vector<CurvePoint> points;
  std::uint64_t nan = 0, faults = 0;

  // What follows from the points.
  std::optional<PowerLaw> relRmseOverSamples, relRmseOverSeconds;  // over the last doublings
  std::optional<Crossing> secondsToTarget;
  double efficiency = 0.0;  // 1 / (MSE * seconds) at the last point; constant for independent samples
};

struct SceneReport {
  std::string name, project;
  DeviceDescription device;
  Extent film;
  int runs = 0;
  std::uint64_t referenceSamples = 0;
  double referenceRelRmse = 0.0;              // its own error, by its half-buffers
  std::optional<double> relMseToFirstDevice;  // of the same few samples, which only rounding tells apart
  std::vector<Curve> curves;                  // the first is the renderer as it is
};

struct Report {
  std::string version, command;
  std::vector<SceneReport> scenes;
};

/// Medians over runs[run][point]; every run holds the same sample counts.
Curve curveOf(std::string id, std::string label, const std::vector<std::vector<Sample>>& runs);

std::string jsonOf(const Report& report);
/// The files of a scene's two plots.
struct PlotNames {
  std::string overSeconds, overSamples;
};
/// A table for each scene on each device, with its plots; `plotNames` are the files beside it, for each
/// scene.
std::string markdownOf(const Report& report, const std::vector<PlotNames>& plotNames);
enum class PlotOver { seconds, samples };
/// Relative RMSE against seconds or samples, both in logarithms: a line for each curve, its name at its end.
/// Over samples, a variant that differs in speed alone is left out: its curve is the first.
std::string svgOf(const SceneReport& scene, PlotOver over);

/// "12 ms", "3.4 s", "2 min 05 s", for people.
std::string shortDuration(double seconds);

}  // namespace steradian::report
