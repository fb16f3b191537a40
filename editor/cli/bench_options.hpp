// SPDX-License-Identifier: MIT
// The options of the bench, shared by `steradian bench` and the bare tool.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace steradian::bench {

/// Adds the options to `command`; the returned function runs the bench and gives the exit code.
/// `self` starts this program's bench again, e.g. {"/proc/self/exe", "bench"}.
std::function<int()> addBenchOptions(CLI::App& command, const std::vector<std::string>& self);

}  // namespace steradian::bench
