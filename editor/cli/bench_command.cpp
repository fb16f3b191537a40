// SPDX-License-Identifier: MIT
// steradian bench: the bench library as a subcommand.
#include <CLI/CLI.hpp>

#include "editor/cli/bench_options.hpp"
#include "editor/cli/commands.hpp"

namespace steradian::cli {

void addBench(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("bench", "Time per sample, rays per second, first pixel, time to an error");
  const auto run = bench::addBenchOptions(*command, {"/proc/self/exe", "bench"});
  command->callback([run, &chosen] { chosen = run; });
}

}  // namespace steradian::cli
