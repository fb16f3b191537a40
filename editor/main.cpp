// SPDX-License-Identifier: MIT
// The one binary: reads the command line, runs the subcommand, turns every error into a line and an exit
// code.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "editor/cli/commands.hpp"
#include "editor/cli/console.hpp"
#include "editor/version.hpp"
#include "renderer/scene/error.hpp"

namespace {

using namespace steradian;

void describe(CLI::App& app, cli::Command& chosen) {
  app.set_version_flag("--version", std::string("steradian ") + kVersion);
  app.require_subcommand(0, 1);
  app.get_formatter()->column_width(34);
  app.footer(
      "Examples:\n"
      "  steradian projects/cornell                        edit a project\n"
      "  steradian render projects/cornell -o cornell.exr --until rel=1% --until time=5m\n"
      "  steradian SUBCOMMAND --help                       options of a subcommand\n"
      "Exit codes: 0 ok, 1 failed, 2 usage, 3 bad input, 4 no device, 5 files or disk, 6 plugin, 130/143/129 "
      "signals.");
  cli::addEdit(app, chosen);
  cli::addRender(app, chosen);
  cli::addMerge(app, chosen);
  cli::addCompare(app, chosen);
  cli::addReport(app, chosen);
  cli::addConvert(app, chosen);
  cli::addInfo(app, chosen);
  cli::addDevices(app, chosen);
  cli::addPlugins(app, chosen);
  cli::addBench(app, chosen);
}

/// What is written before a subcommand belongs to `edit`, which would not run.
void refuseWordsBefore(const CLI::App& app) {
  if (app.get_subcommands().empty()) return;
  const std::string subcommand = app.get_subcommands().front()->get_name();
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0)
      throw Error(ExitCode::usage,
                  "'" + option->results().front() + "' before '" + subcommand +
                      "' means nothing; what is meant for a subcommand follows it: steradian " + subcommand +
                      " --help");
}

int fail(ExitCode code, const std::string& message) {
  cli::fail(message);
  return int(code);
}

}  // namespace

int main(int argc, char** argv) try {
  cli::secondsSinceStart();
  CLI::App app("Steradian: a scene editor with a live, physically based, ray-traced viewport.", "steradian");
  cli::Command chosen;
  describe(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return fail(ExitCode::usage, std::string(error.what()) + "; steradian --help shows what there is");
  }
  refuseWordsBefore(app);
  const int code = chosen();
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) return fail(ExitCode::io, "stdout cannot be written");
  return code;
} catch (const steradian::Error& error) {
  return fail(error.code(), error.what());
} catch (const std::bad_alloc&) {
  return fail(ExitCode::failed, "out of memory; try a smaller --size");
} catch (const std::exception& error) {
  return fail(ExitCode::failed, error.what());
}
