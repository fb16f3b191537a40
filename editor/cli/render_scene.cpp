// SPDX-License-Identifier: MIT
// Reads the scene and applies the command line's overrides.
#include "editor/cli/render_scene.hpp"

#include <algorithm>
#include <set>

#include "editor/assets.hpp"
#include "editor/cli/arguments.hpp"
#include "editor/cli/console.hpp"
#include "editor/first_view.hpp"
#include "renderer/scene/validate.hpp"

namespace steradian::cli {

namespace {

void applyRenderOverrides(Scene& scene, const RenderOptions& options) {
  if (!options.size.empty()) {
    const Extent film = parseSize(options.size);
    scene.render.width = film.width;
    scene.render.height = film.height;
  }
  scene.render.maxBounces = options.bounces.value_or(scene.render.maxBounces);
  scene.render.seed = options.seed.value_or(scene.render.seed);
  if (options.noMeter) scene.render.errorMeter = false;
  scene.display.exposure = options.exposure.value_or(scene.display.exposure);
}

/// A known id is the tonemapper's, an exporter's, or both; every other id is a typing mistake.
void applyParameters(PreparedScene& prepared, const plugins::PluginHost& host, const RenderOptions& options) {
  const plugins::Contribution* tonemapper = host.tonemapper(prepared.scene.display.tonemapper);
  std::set<std::string> ofTonemapper, ofExporters;
  if (tonemapper)
    for (const auto& parameter : tonemapper->parameters) ofTonemapper.insert(parameter.id);
  for (const auto& path : options.outputs)
    for (const auto& parameter : host.exporterFor(path, true)->parameters) ofExporters.insert(parameter.id);
  for (const std::string& text : options.parameters) {
    const auto [id, value] = parseParameter(text);
    if (ofTonemapper.count(id)) prepared.scene.display.parameters[id] = float(value);
    if (ofExporters.count(id)) prepared.exporterParameters[id] = value;
    if (ofTonemapper.count(id) || ofExporters.count(id)) continue;
    std::set<std::string> known = ofTonemapper;
    known.insert(ofExporters.begin(), ofExporters.end());
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    throw Error(ExitCode::usage, "--param: neither the tonemapper nor an exporter has '" + id + "'; " +
                                     (list.empty() ? "they have no parameters" : "they have " + list));
  }
}

/// Projects are rendered as they are; models may lack camera and light.
bool isProject(const std::filesystem::path& input) {
  std::error_code ignored;
  return std::filesystem::is_directory(input, ignored) || input.extension() == ".srad";
}

void checkOverrides(const Scene& scene) {
  const auto problems = problemsOf(scene);
  if (!problems.empty()) throw Error(ExitCode::usage, problems[0].where + " " + problems[0].what);
}

}  // namespace

PreparedScene prepareScene(const plugins::PluginHost& host, const RenderOptions& options) {
  plugins::Progress progress;
  progress.log = [](const std::string& text) { warn(text); };
  plugins::ImportResult imported = host.importScene(options.input, progress);
  for (const auto& line : imported.report.notKept)
    warn(options.input.string() + ": " + line.what + ": " + line.why);
  for (const std::string& warning : loadAssets(imported.scene, projectFolderOf(options.input))) warn(warning);
  PreparedScene prepared{std::move(imported.scene), {}};
  Scene& scene = prepared.scene;
  if (options.frame) scene = evaluatedAt(scene, double(*options.frame) / scene.animation.framesPerSecond);
  if (options.time) scene = evaluatedAt(scene, *options.time);
  applyRenderOverrides(scene, options);
  if (!isProject(options.input)) {
    FirstView first = withFirstView(std::move(scene));
    scene = std::move(first.scene);
    if (!first.added.empty())
      note(options.input.string() + ": has none of its own, so it is rendered with " + first.added);
  }
  if (!options.tonemapper.empty()) {
    const plugins::Contribution* tonemapper = host.tonemapper(options.tonemapper);
    scene.display.tonemapper = tonemapper ? tonemapper->id : options.tonemapper;
  }
  applyParameters(prepared, host, options);
  checkOverrides(scene);
  return prepared;
}

}  // namespace steradian::cli
