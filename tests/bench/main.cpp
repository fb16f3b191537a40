// SPDX-License-Identifier: MIT
// The bench alone: needs neither a window system nor image libraries, so it starts on a bare GPU machine.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "editor/cli/bench_options.hpp"
#include "renderer/scene/error.hpp"

int main(int argc, char** argv) try {
  CLI::App app("Measures Steradian's renderer.", "steradian_bench_tool");
  const auto run = steradian::bench::addBenchOptions(app, {"/proc/self/exe"});
  CLI11_PARSE(app, argc, argv);
  return run();
} catch (const steradian::Error& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return int(error.code());
}
