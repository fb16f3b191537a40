// SPDX-License-Identifier: MIT
// Programs started by the GUI tests, ended with them; and an X server whose screen can be read.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/image.hpp"

namespace steradian::test {

class Process {
 public:
  using Environment = std::map<std::string, std::string>;
  /// `output` takes stdout and stderr; empty = dropped. Throws std::runtime_error when it cannot be started.
  Process(const std::vector<std::string>& command, const Environment& more,
          const std::filesystem::path& folder, const std::filesystem::path& output);
  ~Process();  // SIGTERM, then SIGKILL
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  bool running();
  /// The exit code; nullopt when it still runs after `limit`.
  std::optional<int> wait(std::chrono::seconds limit);

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;
};

/// Xvfb with openbox on a display number that is free.
class Screen {
 public:
  /// `folder` receives the frame buffer file.
  Screen(const std::filesystem::path& folder, int width, int height);
  const std::string& display() const { return display_; }  // ":99"
  /// Of the monitor, for programs that start later; 96 until then.
  void setDpi(int dpi);
  /// What is on the screen, RGB in [0, 1], the pointer included.
  Image read() const;

 private:
  std::filesystem::path folder_;
  std::string display_;
  std::optional<Process> server_, windowManager_;
};

}  // namespace steradian::test
