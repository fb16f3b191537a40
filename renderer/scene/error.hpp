// SPDX-License-Identifier: MIT
// The one exception type for faults of the world (files, devices, plugins); our own mistakes are asserts.
#pragma once
#include <stdexcept>
#include <string>

namespace steradian {

/// Process exit codes of the command line; every Error carries the one it ends in.
enum class ExitCode : int { ok = 0, failed = 1, usage = 2, badInput = 3, noDevice = 4, io = 5, plugin = 6 };

/// One clear line: file, place, cause and remedy. Caught at the edge (command, panel, plugin border).
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace steradian
