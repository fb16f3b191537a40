// SPDX-License-Identifier: MIT
// SIGINT, SIGTERM and SIGHUP ask a long command to finish early and keep what it has.
#pragma once
#include <array>
#include <csignal>

namespace steradian::cli {

/// While it lives, the first signal is only noted and a second one ends the process as usual.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  int signal() const;  // 0 = none so far
  /// 128 + signal, the shell's convention: 130, 143, 129.
  int exitCode() const { return 128 + signal(); }

 private:
  std::array<struct sigaction, 3> previous_{};
};

}  // namespace steradian::cli
