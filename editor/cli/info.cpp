// SPDX-License-Identifier: MIT
// steradian info FILE: what a scene or an image holds.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "editor/assets.hpp"
#include "editor/cli/commands.hpp"
#include "editor/cli/console.hpp"
#include "editor/cli/info_assets.hpp"
#include "editor/edits.hpp"
#include "editor/image_file.hpp"
#include "plugins/host/plugin_host.hpp"

namespace steradian::cli {

namespace {

struct InfoOptions {
  std::filesystem::path file;
  std::vector<std::filesystem::path> pluginPath;
  bool json = false;
};

/// "sky.exr": its size, or why it cannot be used.
Json imagesOf(const Scene& scene) {
  Json images = Json::object();
  for (const Object& object : scene.objects) {
    const auto* light = std::get_if<Light>(&object.content);
    const auto* sky = light ? std::get_if<EnvironmentLight>(&light->kind) : nullptr;
    if (!sky || sky->file.empty()) continue;
    images[sky->file] = sky->image
                            ? std::to_string(sky->image->width) + "x" + std::to_string(sky->image->height)
                            : std::string("missing");
  }
  return images;
}

/// Reads the files that the scene names first, so that what is missing is told.
Json jsonOf(plugins::ImportResult imported, const std::filesystem::path& file) {
  Scene& scene = imported.scene;
  for (const AssetProblem& problem : Assets().load(scene, projectFolderOf(file))) warn(problem.message);
  std::map<std::string, int> kinds;
  Json cameras = Json::array();
  for (const Object& object : scene.objects) {
    ++kinds[edits::kindName(object.content)];
    if (std::holds_alternative<Camera>(object.content)) cameras.push_back(object.name);
  }
  return {{"kind", "scene"},
          {"name", scene.name},
          {"objects", kinds},
          {"cameras", cameras},
          {"materials", scene.materials.size()},
          {"meshes", meshInfo(scene)},
          {"textures", textureInfo(scene)},
          {"images", imagesOf(scene)},
          {"channels", scene.animation.channels.size()},
          {"width", scene.render.width},
          {"height", scene.render.height},
          {"maxBounces", scene.render.maxBounces},
          {"tonemapper", scene.display.tonemapper},
          {"import", importInfo(imported.report)}};
}

Json jsonOf(const ImageFile& file) {
  return {{"kind", "image"},
          {"format", file.format},
          {"width", file.image.width},
          {"height", file.image.height},
          {"channels", file.image.channels},
          {"channelNames", file.channelNames},
          {"metadata", file.metadata}};
}

/// "key: value" lines; what is nested is indented below its key.
void printText(const Json& json, int indent) {
  for (const auto& [key, value] : json.items()) {
    const std::string name = json.is_array() ? "-" : key + ":";
    if (value.is_structured() && value.empty()) continue;
    std::printf("%*s%s", indent, "", name.c_str());
    if (value.is_structured()) {
      std::puts("");
      printText(value, indent + 2);
    } else {
      std::printf(" %s\n", value.is_string() ? value.get<std::string>().c_str() : value.dump().c_str());
    }
  }
}

int runInfo(const InfoOptions& options) {
  Json json;
  if (isImage(options.file)) {
    json = jsonOf(readImage(options.file));
  } else {
    const plugins::PluginHost host(plugins::defaultSearchPath(options.pluginPath));
    json = jsonOf(host.importScene(options.file), options.file);
  }
  if (options.json)
    std::puts(json.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
  else
    printText(json, 0);
  return 0;
}

}  // namespace

void addInfo(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "What a scene or an image holds");
  command->add_option("file", options->file, "Project, scene file or image")->required();
  command->add_option("--plugin-path", options->pluginPath, "Further folder with plugins; repeatable")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "Machine-readable output");
  command->callback([options, &chosen] { chosen = [options] { return runInfo(*options); }; });
}

}  // namespace steradian::cli
