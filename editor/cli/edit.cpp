// SPDX-License-Identifier: MIT
// steradian [edit] [PROJECT]: opens the editor.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "editor/cli/commands.hpp"
#include "editor/ui/app.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::cli {

namespace {

int runEdit(const EditorOptions& options) {
  std::error_code ignored;
  if (!options.file.empty() && !std::filesystem::exists(options.file, ignored))
    throw Error(ExitCode::badInput,
                "'" + options.file + "' is neither a file nor a subcommand; steradian --help lists those");
  return runEditor(options);
}

}  // namespace

void addEdit(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<EditorOptions>();
  const auto addOptions = [options](CLI::App& target) {
    target.add_option("file", options->file, "A project, its folder, or anything that an importer reads");
    target.add_option("--device", options->device, "Vulkan device by index or part of its name");
    target.add_option("--plugin-path", options->pluginPath, "Further folder with plugins; repeatable")
        ->allow_extra_args(false);
    target.add_flag("--validation", options->validation, "Turn on the Vulkan validation layers");
  };
  addOptions(app);
  CLI::App* command = app.add_subcommand("edit", "Open the editor (also without a subcommand)");
  addOptions(*command);
  chosen = [options] { return runEdit(*options); };
  command->callback([options, &chosen] { chosen = [options] { return runEdit(*options); }; });
}

}  // namespace steradian::cli
