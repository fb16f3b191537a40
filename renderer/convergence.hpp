// SPDX-License-Identifier: MIT
// How the error falls with the samples: its slope, what a target will take, and when not to trust it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/renderer.hpp"

namespace steradian {

/// Keeps RMSE at the doublings of the sample count and fits how it falls.
class SlopeTracker {
 public:
  /// The fit stands on the last four doublings at most: what a render does now, not how it began.
  static constexpr std::size_t kMostDoublings = 4;

  void reset() { *this = {}; }
  /// Ignored until the samples have doubled since the last figure that was kept.
  void add(std::uint64_t samples, double rmse);
  /// d log RMSE / d log samples by least squares over the doublings kept; 0 = not known yet.
  double slope() const;
  int doublings() const { return points_.empty() ? 0 : int(points_.size()) - 1; }

 private:
  struct Point {
    double logSamples, logRmse;
  };
  std::vector<Point> points_;
};

/// Samples at which the relative RMSE reaches `target`, along the fitted slope. RMSE falls as samples^-p,
/// with p 1/2 for independent samples and up to 1 for smooth pixels under Owen-Sobol; less than 1/2 is
/// believed only from three doublings on.
double samplesNeeded(std::uint64_t samples, const ErrorEstimate& error, double target);

/// Fireflies: over three doublings or more the error falls slower than samples^-0.45 while the worst 0.1 % of
/// the pixels carry more than half of it. More samples will find more of them: the estimate itself is too
/// low.
bool heavyTails(const ErrorEstimate& error);
/// One line for people when the tails are heavy, else empty.
std::string tailWarning(const ErrorEstimate& error);
/// One line for people when clamping has taken light from the picture, else empty.
std::string clampWarning(const RenderStats& stats);
/// Everything that a person should know before trusting a finished picture, a line each.
std::vector<std::string> doubtsAbout(const RenderStats& stats);

}  // namespace steradian
