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
#include "editor/cli/image_compare.hpp"
#include "editor/cli/report_progress.hpp"
#include "editor/report/measure.hpp"
#include "editor/tonemapping.hpp"
#include "editor/version.hpp"
#include "plugins/host/atomic_file.hpp"
#include "plugins/host/plugin_host.hpp"
#include "renderer/still.hpp"

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

/// "cornell"; where a scene was measured before, on another device, "cornell-2".
std::string plotStem(const report::Report& report, std::size_t index) {
  fs::path project = report.scenes[index].project;
  if (!project.has_filename()) project = project.parent_path();
  const auto same = std::count_if(report.scenes.begin(), report.scenes.begin() + std::ptrdiff_t(index),
                                  [&](const auto& s) { return s.project == report.scenes[index].project; });
  return project.stem().string() + (same > 0 ? "-" + std::to_string(same + 1) : "");
}

std::vector<report::PlotNames> plotNames(const report::Report& report) {
  std::vector<report::PlotNames> names;
  for (std::size_t i = 0; i < report.scenes.size(); ++i) {
    const std::string stem = plotStem(report, i);
    names.push_back({stem + ".svg", stem + "-samples.svg"});
  }
  return names;
}

/// After each scene, so that a report that is interrupted holds what was finished.
void write(const report::Report& report, const fs::path& folder) {
  const std::vector<report::PlotNames> plots = plotNames(report);
  const report::SceneReport& scene = report.scenes.back();
  plugins::writeFileAtomically(folder / plots.back().overSeconds,
                               report::svgOf(scene, report::PlotOver::seconds));
  plugins::writeFileAtomically(folder / plots.back().overSamples,
                               report::svgOf(scene, report::PlotOver::samples));
  plugins::writeFileAtomically(folder / "report.json", report::jsonOf(report));
  plugins::writeFileAtomically(folder / "report.md", report::markdownOf(report, plots));
}

/// How far the picture of the same few samples is from that of the first device, where it is put into
/// `first`.
std::optional<double> relMseToFirstDevice(Renderer& renderer, const Scene& scene, Extent film, Image& first) {
  renderer.setAblation({});  // of the scene before
  renderer.allowSpecialization(true);
  renderer.setScene(scene, cameraView(scene), film);
  renderStill(renderer, {.spp = 16});
  Image picture = renderer.radiance();
  if (!first.pixels.empty()) return differenceOf(picture, first).relMse;
  first = std::move(picture);
  return std::nullopt;
}

report::SceneReport measured(const plugins::PluginHost& host, const fs::path& project, Renderer& renderer,
                             const report::MeasureOptions& options, ReportProgress& progress, int index,
                             Image* first) {
  Scene scene = host.importScene(project).scene;
  for (const std::string& warning : loadAssets(scene, projectFolderOf(project))) warn(warning);
  const std::string name = scene.name.empty() ? project.filename().string() : scene.name;
  progress.beginScene(index, name);
  std::optional<double> apart;
  if (first) apart = relMseToFirstDevice(renderer, scene, options.film, *first);
  report::SceneReport out =
      report::measureScene(renderer, scene, cameraView(scene), tonemapperFor(host, scene.display), options,
                           [&](const std::string& doing, double part) { progress.show(doing, part); });
  out.name = name;
  out.project = project.string();
  out.relMseToFirstDevice = apart;
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
  std::vector<Image> firsts(projects.size());  // one picture of each project, by the first device
  {
    ReportProgress progress(int(projects.size() * options.devices.size()));
    for (const std::string& name : options.devices) {
      const auto device = openDevice({.device = name});
      measure.warmUpSeconds = describe(*device).type != "CPU" ? 0.7 : 0.0;
      Renderer renderer(device);
      for (std::size_t i = 0; i < projects.size(); ++i) {
        const int done = int(report.scenes.size());
        Image* first = options.devices.size() > 1 ? &firsts[i] : nullptr;
        report.scenes.push_back(measured(host, projects[i], renderer, measure, progress, done, first));
        report.scenes.back().device = describe(*device);
        write(report, folder);
      }
    }
  }
  for (const char* name : {"report.md", "report.json"}) std::puts((folder / name).c_str());
  for (const report::PlotNames& plots : plotNames(report))
    for (const std::string& plot : {plots.overSeconds, plots.overSamples}) std::puts((folder / plot).c_str());
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
      ->check(aboveZero)
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
