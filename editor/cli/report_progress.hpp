// SPDX-License-Identifier: MIT
// Progress of a report on stderr, with an estimate of what is left.
#pragma once
#include <chrono>
#include <optional>
#include <string>

namespace steradian::cli {

/// Seconds left of `scenes` scenes of about equal length, `done` of them done and `fraction` of the next;
/// nothing until enough is known.
std::optional<double> remainingOf(double elapsedSeconds, int scenes, int done, double fraction);

/// One line that rewrites itself on a terminal, else a plain line now and then.
class ReportProgress {
 public:
  explicit ReportProgress(int scenes);
  ~ReportProgress();  // wipes the line from a terminal
  void beginScene(int index, std::string name);
  void show(const std::string& doing, double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  int scenes_, index_ = 0;
  std::string name_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> shown_;
};

}  // namespace steradian::cli
