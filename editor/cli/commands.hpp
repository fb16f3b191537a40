// SPDX-License-Identifier: MIT
// The subcommands: each file adds its own options to the parser and says what to run when it is chosen.
#pragma once
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace steradian::cli {

/// What the command line chose; returns the process exit code, throws Error.
using Command = std::function<int()>;

void addEdit(CLI::App& app, Command& chosen);  // also what runs without a subcommand
void addRender(CLI::App& app, Command& chosen);
void addDevices(CLI::App& app, Command& chosen);
void addInfo(CLI::App& app, Command& chosen);
void addConvert(CLI::App& app, Command& chosen);
void addPlugins(CLI::App& app, Command& chosen);
void addBench(CLI::App& app, Command& chosen);
void addCompare(CLI::App& app, Command& chosen);
void addReport(CLI::App& app, Command& chosen);
void addMerge(CLI::App& app, Command& chosen);

}  // namespace steradian::cli
