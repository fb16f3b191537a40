// SPDX-License-Identifier: MIT
// How long the frame loop was busy in each frame: what a person feels as a stall, for measurements and tests.
#pragma once
#include <chrono>
#include <filesystem>
#include <vector>

namespace steradian::ui {

class FrameTimes {
 public:
  /// `file` empty = nothing is measured.
  explicit FrameTimes(std::filesystem::path file) : file_(std::move(file)) {}
  static FrameTimes fromEnvironment();  // STERADIAN_FRAME_TIMES=FILE

  /// Between begin() and end() the window does not answer; waiting for events lies outside.
  void begin() { began_ = Clock::now(); }
  void end();
  /// One line per frame: its begin in seconds since the first one, and its milliseconds.
  void write() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Frame {
    Clock::time_point begin;
    double milliseconds = 0.0;
  };
  std::filesystem::path file_;
  Clock::time_point began_;
  std::vector<Frame> frames_;
};

}  // namespace steradian::ui
