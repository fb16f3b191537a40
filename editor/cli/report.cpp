// SPDX-License-Identifier: MIT
// steradian report [PROJECT...]: error against time as JSON, a table and plots.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <bit>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>

#include "editor/assets.hpp"
#include "editor/cli/arguments.hpp"
#include "editor/cli/commands.hpp"
#include "editor/cli/console.hpp"
#include "editor/cli/report_progress.hpp"
#include "editor/report/measure.hpp"
#include "editor/version.hpp"
#include "plugins/host/atomic_file.hpp"
#include "plugins/host/plugin_host.hpp"

namespace steradian::cli {

namespace {

namespace fs = std::filesystem;

/// Scenes of the source tree that are neither tests of rounding nor of one closed form.
constexpr const char* kStockProjects[] = {
    "projects/thesis-room", "projects/cornell", "projects/material-grid", "projects/veach",
    "projects/glass",       "projects/sky",     "projects/many-lights"};

struct ReportOptions {
  std::vector<fs::path> projects, pluginPath;
  std::vector<std::string> devices = {""};  // "": the best there is
  fs::path output = "report";
  std::string size;
  report::MeasureOptions measure;
};

std::vector<fs::path> projectsOf(const ReportOptions& options) {
  if (!options.projects.empty()) return options.projects;
  for (const char* project : kStockProjects)
    if (!fs::exists(project))
      throw Error(ExitCode::usage, std::string("there is no ") + project +
                                       " here; name the projects, or run it in Steradian's source folder");
  return {std::begin(kStockProjects), std::end(kStockProjects)};
}

fs::path makeFolder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw Error(ExitCode::io, folder.string() + ": cannot be made: " + failure.message());
  return folder;
}

/// How to make this report again, for a shell.
std::string commandLine() {
  std::ifstream stream("/proc/self/cmdline", std::ios::binary);
  const std::string raw((std::istreambuf_iterator<char>(stream)), {});
  std::string out;
  for (std::size_t at = 0; at < raw.size();) {
    const std::size_t end = std::min(raw.find('\0', at), raw.size());
    std::string word = raw.substr(at, end - at);
    if (at == 0) word = fs::path(word).filename();
    const bool plain = word.find_first_of(" \t\n'\"\\$&|;<>()*?[]{}~#`!") == word.npos && !word.empty();
    out += (out.empty() ? "" : " ") + (plain ? word : "'" + word + "'");
    at = end + 1;
  }
  return out;
}

/// "cornell.svg"; where a scene was measured before, on another device, "cornell-2.svg".
std::string plotName(const report::Report& report, std::size_t index) {
  fs::path project = report.scenes[index].project;
  if (!project.has_filename()) project = project.parent_path();
  const auto same = std::count_if(report.scenes.begin(), report.scenes.begin() + std::ptrdiff_t(index),
                                  [&](const auto& s) { return s.project == report.scenes[index].project; });
  return project.stem().string() + (same > 0 ? "-" + std::to_string(same + 1) : "") + ".svg";
}

std::vector<std::string> plotNames(const report::Report& report) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < report.scenes.size(); ++i) names.push_back(plotName(report, i));
  return names;
}

/// After each scene, so that a report that is interrupted holds what was finished.
void write(const report::Report& report, const fs::path& folder) {
  const std::vector<std::string> plots = plotNames(report);
  plugins::writeFileAtomically(folder / plots.back(), report::svgOf(report, report.scenes.back()));
  plugins::writeFileAtomically(folder / "report.json", report::jsonOf(report));
  plugins::writeFileAtomically(folder / "report.md", report::markdownOf(report, plots));
}

report::SceneReport measured(const plugins::PluginHost& host, const fs::path& project, Renderer& renderer,
                             const report::MeasureOptions& options, ReportProgress& progress, int index) {
  Scene scene = host.importScene(project).scene;
  for (const std::string& warning : loadAssets(scene, projectFolderOf(project))) warn(warning);
  const std::string name = scene.name.empty() ? project.filename().string() : scene.name;
  progress.beginScene(index, name);
  report::SceneReport out =
      report::measureScene(renderer, scene, cameraView(scene), options,
                           [&](const std::string& doing, double part) { progress.show(doing, part); });
  out.name = name;
  out.project = project.string();
  return out;
}

int runReport(const ReportOptions& options) {
  report::MeasureOptions measure = options.measure;
  if (!options.size.empty()) measure.film = parseSize(options.size);
  measure.maxSamples = std::bit_floor(measure.maxSamples);
  const std::vector<fs::path> projects = projectsOf(options);
  const plugins::PluginHost host(plugins::defaultSearchPath(options.pluginPath));
  const fs::path folder = makeFolder(options.output);
  report::Report report{kVersion, commandLine(), {}};
  {
    ReportProgress progress(int(projects.size() * options.devices.size()));
    for (const std::string& name : options.devices) {
      const auto device = openDevice({.device = name});
      measure.warmUpSeconds = describe(*device).type != "CPU" ? 0.7 : 0.0;
      Renderer renderer(device);
      for (const fs::path& project : projects) {
        const int done = int(report.scenes.size());
        report.scenes.push_back(measured(host, project, renderer, measure, progress, done));
        report.scenes.back().device = describe(*device);
        write(report, folder);
      }
    }
  }
  for (const char* name : {"report.md", "report.json"}) std::puts((folder / name).c_str());
  for (const std::string& plot : plotNames(report)) std::puts((folder / plot).c_str());
  return 0;
}

}  // namespace

void addReport(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<ReportOptions>();
  report::MeasureOptions& m = options->measure;
  CLI::App* command = app.add_subcommand("report", "Error against time: table, JSON and plots");
  command->add_option("projects", options->projects, "Projects to measure; default: the stock scenes");
  command->add_option("-o,--output", options->output, "Folder to write report.md, report.json and plots to")
      ->capture_default_str();
  command->add_flag("--ablate", m.ablate, "Also with each feature switched off");
  command->add_option("--size", options->size, "Width and height in pixels (default 256x192)");
  command->add_option("--max-spp", m.maxSamples, "Most samples of a run, rounded down to a power of two")
      ->check(CLI::Range(8, 1 << 24))
      ->capture_default_str();
  command
      ->add_option("--seconds", m.seconds,
                   "Tracing time for each scene, reference included; fewer samples are taken to keep it")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--runs", m.runs, "Runs with different seeds, of which medians are reported")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--device", options->devices,
                   "Vulkan device by index or part of its name; repeatable: all scenes on each")
      ->allow_extra_args(false);
  command->add_option("--plugin-path", options->pluginPath, "Further folder with plugins; repeatable")
      ->allow_extra_args(false);
  command->callback([options, &chosen] { chosen = [options] { return runReport(*options); }; });
}

}  // namespace steradian::cli
