// SPDX-License-Identifier: MIT
// steradian plugins: what was found, and why the rest was not loaded.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "editor/cli/commands.hpp"
#include "plugins/host/plugin_host.hpp"

namespace steradian::cli {

namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(plugins::Kind kind) {
  switch (kind) {
    case plugins::Kind::importer:
      return "importer";
    case plugins::Kind::exporter:
      return "exporter";
    case plugins::Kind::tonemapper:
      return "tonemapper";
  }
  return "";
}

Json jsonOf(const plugins::Contribution& contribution) {
  Json parameters = Json::array();
  for (const auto& p : contribution.parameters)
    parameters.push_back({{"id", p.id},
                          {"name", p.name},
                          {"unit", p.unit},
                          {"help", p.help},
                          {"default", p.defaultValue},
                          {"minimum", p.minimum},
                          {"maximum", p.maximum}});
  return {{"kind", nameOf(contribution.kind)},
          {"id", contribution.id},
          {"name", contribution.name},
          {"version", contribution.version},
          {"extensions", contribution.extensions},
          {"parameters", parameters}};
}

void printJson(const plugins::PluginHost& host) {
  Json list = Json::array();
  for (const plugins::PluginFile& file : host.files()) {
    Json contributions = Json::array();
    for (const auto& contribution : file.contributions) contributions.push_back(jsonOf(contribution));
    list.push_back({{"path", file.path.string()},
                    {"loaded", file.loaded},
                    {"reason", file.reason},
                    {"contributions", contributions}});
  }
  std::puts(list.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

void printText(const plugins::PluginHost& host) {
  for (const plugins::PluginFile& file : host.files()) {
    for (const auto& contribution : file.contributions) {
      std::string extensions;
      for (const auto& extension : contribution.extensions) extensions += " " + extension;
      std::printf("%-10s  %-42s  %-8s %s%s\n", nameOf(contribution.kind), contribution.id.c_str(),
                  contribution.version.c_str(), contribution.name.c_str(), extensions.c_str());
    }
    if (!file.loaded) std::printf("%-10s  %s: %s\n", "failed", file.path.c_str(), file.reason.c_str());
  }
}

}  // namespace

void addPlugins(CLI::App& app, Command& chosen) {
  struct Options {
    bool json = false;
    std::vector<std::filesystem::path> pluginPath;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("plugins", "Importers, exporters and tonemappers");
  CLI::App* list = command->add_subcommand("list", "What was found, and why the rest was not loaded");
  for (CLI::App* target : {command, list}) {
    target->add_flag("--json", options->json, "Machine-readable output");
    target->add_option("--plugin-path", options->pluginPath, "Further folder with plugins; repeatable")
        ->allow_extra_args(false);
  }
  command->callback([options, &chosen] {
    chosen = [options] {
      const plugins::PluginHost host(plugins::defaultSearchPath(options->pluginPath));
      options->json ? printJson(host) : printText(host);
      return 0;
    };
  });
}

}  // namespace steradian::cli
