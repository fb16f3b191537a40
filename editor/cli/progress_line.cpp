// SPDX-License-Identifier: MIT
// Progress with an estimate of what is left.
#include "editor/cli/progress_line.hpp"

#include <cstdio>

#include "editor/cli/console.hpp"

namespace steradian::cli {

namespace {
constexpr double kTerminalEvery = 0.1, kPlainEvery = 5.0, kFirstPlain = 1.0;  // seconds
}

ProgressLine::ProgressLine()
    : terminal_(stderrIsTerminal()), shownAt_(terminal_ ? -kTerminalEvery : kFirstPlain - kPlainEvery) {}

ProgressLine::~ProgressLine() {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(const StillProgress& progress) {
  if (progress.seconds - shownAt_ < (terminal_ ? kTerminalEvery : kPlainEvery)) return;
  shownAt_ = progress.seconds;
  const std::string line = progressText(progress);
  if (terminal_)
    std::fprintf(stderr, "\r%s\033[K", line.c_str());
  else
    std::fprintf(stderr, "%s\n", line.c_str());
  std::fflush(stderr);
}

std::string progressText(const StillProgress& progress) {
  std::string line =
      text("%3.0f %%  %llu samples", progress.fraction * 100.0, (unsigned long long)(progress.samples));
  if (progress.error.valid) line += ", error " + percent(progress.error.relRmse);
  line += ", " + duration(progress.seconds);
  if (progress.remainingSeconds) line += ", about " + duration(*progress.remainingSeconds) + " left";
  return line;
}

}  // namespace steradian::cli
