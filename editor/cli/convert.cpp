// SPDX-License-Identifier: MIT
// steradian convert IN OUT: an importer, then an exporter.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "editor/assets.hpp"
#include "editor/cli/commands.hpp"
#include "editor/cli/console.hpp"
#include "plugins/host/plugin_host.hpp"

namespace steradian::cli {

namespace {

struct ConvertOptions {
  std::filesystem::path input, output;
  std::vector<std::filesystem::path> pluginPath;
};

int runConvert(const ConvertOptions& options) {
  const plugins::PluginHost host(plugins::defaultSearchPath(options.pluginPath));
  if (!host.exporterFor(options.output, false)) {
    std::string known;
    for (const auto* exporter : host.contributions(plugins::Kind::exporter))
      for (const auto& extension : exporter->takesScene ? exporter->extensions : std::vector<std::string>{})
        known += (known.empty() ? "" : ", ") + extension;
    throw Error(ExitCode::usage,
                options.output.string() + ": no exporter writes scenes of this kind; " +
                    (known.empty() ? "no scene exporter plugin was found" : "choose one of " + known));
  }
  plugins::Progress progress;
  progress.log = [](const std::string& text) { warn(text); };
  const auto imported = host.importScene(options.input, progress);
  for (const auto& line : imported.report.notKept)
    warn(options.input.string() + ": " + line.what + ": " + line.why);
  const Scene scene = withAssetsNamedFrom(imported.scene, projectFolderOf(options.input),
                                          projectFolderOf(std::filesystem::absolute(options.output)));
  host.exportScene(scene, options.output, progress);
  std::printf("%s: %zu objects, %zu materials\n", options.output.c_str(), imported.scene.objects.size(),
              imported.scene.materials.size());
  return 0;
}

}  // namespace

void addConvert(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand("convert", "Read a scene file and write it in another format");
  command->add_option("input", options->input, "Scene to read")->required();
  command->add_option("output", options->output, "Scene to write")->required();
  command->add_option("--plugin-path", options->pluginPath, "Further folder with plugins; repeatable")
      ->allow_extra_args(false);
  command->callback([options, &chosen] { chosen = [options] { return runConvert(*options); }; });
}

}  // namespace steradian::cli
