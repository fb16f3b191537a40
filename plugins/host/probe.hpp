// SPDX-License-Identifier: MIT
// Opens an unknown plugin in a child process first, so that a crash of its static initialisers costs one
// line.
#pragma once
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "plugins/host/plugin_host.hpp"

namespace steradian::plugins {

struct ProbeResult {
  std::string reason;  // why it cannot be used; empty = it can
  std::vector<Contribution> contributions;
};

/// How long a plugin may take to load. Two clocks: on a busy or cold disk a hundred libraries may come
/// slowly, yet only a plugin that hangs computes for long.
struct ProbeLimits {
  std::chrono::seconds ownTime{10};            // of the processor, then it loops
  std::chrono::milliseconds patience{60'000};  // from the call of collect(), then it sleeps
};

/// A running probe. Start several, then collect: they run side by side. Construct it before the process has
/// other threads: the child is a fork, and a lock that another thread held would stay locked in it (then it
/// times out).
class Probe {
 public:
  explicit Probe(const std::filesystem::path& file, ProbeLimits limits = {});
  Probe(Probe&& other) noexcept;
  Probe& operator=(Probe&&) = delete;
  ~Probe();  // kills a child that was not collected

  /// Waits for the child, which is killed at its limits.
  ProbeResult collect();

 private:
  ProbeLimits limits_;
  int child_ = -1;  // process id
  int pipe_ = -1;
  std::string startFault_;
};

}  // namespace steradian::plugins
