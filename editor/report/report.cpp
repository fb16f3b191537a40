// SPDX-License-Identifier: MIT
// From runs to curves.
#include "editor/report/report.hpp"

#include <algorithm>
#include <cmath>

#include "editor/cli/console.hpp"

namespace steradian::report {

namespace {

/// The slope is that of the last four doublings: the first samples of a sequence are not yet typical.
constexpr std::size_t kFittedPoints = 5;

template <class Value>
std::vector<double> at(const std::vector<std::vector<Sample>>& runs, std::size_t point, Value&& value) {
  std::vector<double> values;
  for (const auto& run : runs) values.push_back(value(run[point]));
  return values;
}

/// 0 where the reference is not good enough to tell.
double root(double square) {
  return std::sqrt(std::max(square, 0.0));
}

/// Estimated over true error, 0 where nothing was estimated or found.
double ratioOf(const std::vector<std::vector<Sample>>& runs, std::size_t point, double Sample::*estimated,
               double Sample::*found) {
  double of = 0.0, over = 0.0;
  for (const auto& run : runs) of += run[point].*estimated, over += run[point].*found;
  return over > 0.0 ? std::sqrt(of / over) : 0.0;
}

CurvePoint pointOf(const std::vector<std::vector<Sample>>& runs, std::size_t i) {
  CurvePoint point;
  point.samples = runs.front()[i].samples;
  point.seconds = spreadOf(at(runs, i, [](const Sample& s) { return s.seconds; }));
  point.rmse = spreadOf(at(runs, i, [](const Sample& s) { return root(s.mse); }));
  point.relRmse = spreadOf(at(runs, i, [](const Sample& s) { return root(s.relMse); }));
  point.smapeDisplay = spreadOf(at(runs, i, [](const Sample& s) { return s.smapeDisplay; }));
  point.meterRatio = ratioOf(runs, i, &Sample::estimatedMse, &Sample::mse);
  point.relMeterRatio = ratioOf(runs, i, &Sample::estimatedRelMse, &Sample::relMse);
  return point;
}

template <class X>
std::optional<PowerLaw> fitOver(const std::vector<CurvePoint>& points, X&& x) {
  std::vector<Point> fitted;
  for (const CurvePoint& p : points) fitted.push_back({x(p), p.relRmse.median});
  const std::size_t count = std::min(kFittedPoints, fitted.size());
  return fitPowerLaw(std::span(fitted).last(count));
}

}  // namespace

Curve curveOf(std::string id, std::string label, const std::vector<std::vector<Sample>>& runs) {
  Curve curve{std::move(id), std::move(label)};
  for (std::size_t i = 0; i < runs.front().size(); ++i) curve.points.push_back(pointOf(runs, i));
  curve.relRmseOverSamples = fitOver(curve.points, [](const CurvePoint& p) { return double(p.samples); });
  curve.relRmseOverSeconds = fitOver(curve.points, [](const CurvePoint& p) { return p.seconds.median; });
  std::vector<Point> overTime;
  for (const CurvePoint& p : curve.points) overTime.push_back({p.seconds.median, p.relRmse.median});
  const CurvePoint& last = curve.points.back();
  if (curve.relRmseOverSamples && last.relRmse.median > 0.0) {
    // From the last point on, along the slope over samples: times of the first few are noise and overhead.
    const double exponent = curve.relRmseOverSamples->exponent;
    const PowerLaw onwards{last.relRmse.median / std::pow(last.seconds.median, exponent), exponent};
    curve.secondsToTarget = crossingOf(overTime, onwards, kTarget);
  }
  const double cost = last.rmse.median * last.rmse.median * last.seconds.median;
  curve.efficiency = cost > 0.0 ? 1.0 / cost : 0.0;
  return curve;
}

std::string shortDuration(double seconds) {
  if (seconds < 1.0) return cli::text("%.3g ms", seconds * 1e3);
  if (seconds < 99.5) return cli::text("%.3g s", seconds);
  const int whole = int(seconds + 0.5);
  if (whole < 3600) return cli::text("%d min %02d s", whole / 60, whole % 60);
  return cli::text("%.3g h", seconds / 3600.0);
}

}  // namespace steradian::report
