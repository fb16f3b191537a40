// SPDX-License-Identifier: MIT
// Least squares in logarithms.
#include "renderer/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace steradian {

void SlopeTracker::add(std::uint64_t samples, double rmse) {
  const double logSamples = std::log(double(samples));
  if (!points_.empty() && logSamples < points_.back().logSamples + 0.999 * std::log(2.0)) return;
  if (!(rmse > 0.0)) return;
  points_.push_back({logSamples, std::log(rmse)});
  if (points_.size() > kMostDoublings + 1) points_.erase(points_.begin());
}

double SlopeTracker::slope() const {
  if (points_.size() < 2) return 0.0;
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Point& p : points_) x += p.logSamples, y += p.logRmse;
  x /= double(points_.size());
  y /= double(points_.size());
  for (const Point& p : points_) {
    xx += (p.logSamples - x) * (p.logSamples - x);
    xy += (p.logSamples - x) * (p.logRmse - y);
  }
  return xy / xx;
}

double samplesNeeded(std::uint64_t samples, const ErrorEstimate& error, double target) {
  const double slowest = error.doublings >= 3 ? 0.25 : 0.5;
  const double exponent = std::clamp(-error.slope, slowest, 1.0);
  return double(samples) * std::pow(error.relRmse / target, 1.0 / exponent);
}

bool heavyTails(const ErrorEstimate& error) {
  return error.valid && error.doublings >= 3 && error.slope > -0.45 && error.tails.share > 0.5;
}

std::string tailWarning(const ErrorEstimate& error) {
  if (!error.tails.heavy) return {};
  char line[200], falls[48] = "does not fall";
  if (error.slope < -0.05) std::snprintf(falls, sizeof falls, "falls as samples^%.2f only", error.slope);
  std::snprintf(line, sizeof line,
                "fireflies: %llu pixels carry %.0f %% of the squared error, and it %s; the true error is "
                "likely larger than the estimate",
                (unsigned long long)(error.tails.pixels), error.tails.share * 100.0, falls);
  return line;
}

std::string clampWarning(const RenderStats& stats) {
  const double removed = 100.0 * stats.clampedShare.value_or(0.0);
  if (!(removed > 0.0)) return {};
  char line[160];
  std::snprintf(line, sizeof line,
                "the clamp removed %.*f %% of the light; switch it off in the render settings to keep it",
                removed < 0.1 ? 3 : 1, removed);
  return line;
}

std::vector<std::string> doubtsAbout(const RenderStats& stats) {
  std::vector<std::string> lines;
  if (stats.nanSamples > 0)
    lines.push_back(std::to_string(stats.nanSamples) + " samples were not a number and were left out");
  if (stats.faults > 0)
    lines.push_back(
        std::to_string(stats.faults) +
        " samples ran out of their loop budget or were too bright for a film; the picture may be wrong");
  for (const std::string& line : {tailWarning(stats.error), clampWarning(stats)})
    if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace steradian
