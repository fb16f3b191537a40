// SPDX-License-Identifier: MIT
// Where a report is, and when it will be done.
#include "editor/cli/report_progress.hpp"

#include <algorithm>
#include <cstdio>

#include "editor/cli/console.hpp"

namespace steradian::cli {

namespace {
constexpr std::chrono::duration<double> kTerminalEvery{0.1}, kPlainEvery{5.0};
constexpr double kKnownFrom = 0.01;  // of the whole
}  // namespace

std::optional<double> remainingOf(double elapsedSeconds, int scenes, int done, double fraction) {
  const double whole = (double(done) + fraction) / double(std::max(scenes, 1));
  if (!(whole >= kKnownFrom)) return std::nullopt;
  return elapsedSeconds * (1.0 - whole) / whole;
}

ReportProgress::ReportProgress(int scenes) : scenes_(scenes), terminal_(stderrIsTerminal()) {}

ReportProgress::~ReportProgress() {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

void ReportProgress::beginScene(int index, std::string name) {
  index_ = index;
  name_ = std::move(name);
}

void ReportProgress::show(const std::string& doing, double fraction) {
  const auto now = Clock::now();
  if (shown_ && now - *shown_ < (terminal_ ? kTerminalEvery : kPlainEvery)) return;
  shown_ = now;
  std::string line =
      text("%d/%d %s: %s, %.0f %%", index_ + 1, scenes_, name_.c_str(), doing.c_str(), fraction * 100.0);
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  if (const auto left = remainingOf(elapsed, scenes_, index_, fraction))
    line += ", about " + duration(*left) + " left";
  std::fprintf(stderr, terminal_ ? "\r%s\033[K" : "%s\n", line.c_str());
  std::fflush(stderr);
}

}  // namespace steradian::cli
