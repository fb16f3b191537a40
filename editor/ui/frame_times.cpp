// SPDX-License-Identifier: MIT
// Busy times of frames.
#include "editor/ui/frame_times.hpp"

#include <cstdlib>
#include <fstream>

namespace steradian::ui {

FrameTimes FrameTimes::fromEnvironment() {
  const char* file = std::getenv("STERADIAN_FRAME_TIMES");
  return FrameTimes(file ? file : "");
}

void FrameTimes::end() {
  if (file_.empty()) return;
  frames_.push_back({began_, std::chrono::duration<double, std::milli>(Clock::now() - began_).count()});
}

void FrameTimes::write() const {
  if (file_.empty()) return;
  std::ofstream out(file_);
  for (const Frame& frame : frames_)
    out << std::chrono::duration<double>(frame.begin - frames_.front().begin).count() << ' '
        << frame.milliseconds << '\n';
}

}  // namespace steradian::ui
