// SPDX-License-Identifier: MIT
// Files of documents.
#include "editor/ui/project_files.hpp"

#include <unistd.h>
#include <algorithm>

#include "editor/edits.hpp"
#include "editor/first_view.hpp"

namespace steradian::ui {

namespace fs = std::filesystem;

namespace {

/// A project folder means its one .srad.
fs::path fileIn(const fs::path& path) {
  std::error_code failed;
  if (!fs::is_directory(path, failed)) return path;
  fs::path found;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, failed))
    if (entry.path().extension() == ".srad") {
      if (!found.empty()) return path;
      found = entry.path();
    }
  return found.empty() ? path : found;
}

std::vector<std::string> extensionsOf(const plugins::PluginHost& plugins, plugins::Kind kind,
                                      bool sceneOnly) {
  std::vector<std::string> all;
  for (const plugins::Contribution* contribution : plugins.contributions(kind))
    if (!sceneOnly || contribution->takesScene)
      all.insert(all.end(), contribution->extensions.begin(), contribution->extensions.end());
  std::ranges::stable_partition(all, [](const std::string& extension) { return extension == ".srad"; });
  return all;
}

}  // namespace

std::vector<std::string> ProjectFiles::importExtensions() const {
  return extensionsOf(plugins_, plugins::Kind::importer, false);
}

std::vector<std::string> ProjectFiles::saveExtensions() const {
  return extensionsOf(plugins_, plugins::Kind::exporter, true);
}

std::vector<std::string> ProjectFiles::addExtensions() const {
  std::vector<std::string> all = importExtensions();
  all.insert(all.end(), {".hdr", ".exr"});
  return all;
}

bool ProjectFiles::isProject(const fs::path& path) const {
  return fileIn(path).extension() == ".srad";
}

bool ProjectFiles::isSky(const fs::path& path) const {
  const std::string extension = path.extension();
  return extension == ".hdr" || extension == ".exr";
}

Scene ProjectFiles::read(const fs::path& path) {
  const plugins::Progress progress{{}, {}, [this](const std::string& line) { messages_.note(line); }};
  plugins::ImportResult result = plugins_.importScene(path, progress);
  for (const plugins::ImportReport::Line& line : result.report.notKept)
    messages_.warning(path.filename().string() + ": " + line.what + ": " + line.why);
  for (const AssetProblem& problem : assets_.load(result.scene, path.parent_path()))
    problem.missing ? messages_.error(problem.message + "; until then the sky shows its gradient alone.")
                    : messages_.warning(problem.message);
  return std::move(result.scene);
}

std::optional<Document> ProjectFiles::load(const fs::path& given) {
  try {
    const fs::path path = fs::absolute(fileIn(given)).lexically_normal();
    Scene scene = read(path);
    recent_.add(path);
    messages_.note("Opened " + path.string() + ".");
    if (isProject(path)) return Document(std::move(scene), path);
    FirstView first = withFirstView(std::move(scene));
    if (!first.added.empty())
      messages_.note(path.filename().string() + " has none of its own: added " + first.added + ".");
    // What cannot be written back is a new project.
    Document imported(withAssetsNamedFrom(std::move(first.scene), path.parent_path(), {}));
    imported.markUnsaved();
    return imported;
  } catch (const std::exception& error) {
    messages_.error(error.what());
    recent_.remove(given);
    return std::nullopt;
  }
}

std::optional<edits::Merged> ProjectFiles::import(const Document& document, const fs::path& given) {
  try {
    const fs::path path = fs::absolute(fileIn(given)).lexically_normal();
    const Scene scene = withAssetsNamedFrom(read(path), path.parent_path(), projectFolderOf(document.path()));
    edits::Merged merged = edits::merge(document.committed(), scene, path.stem().string());
    messages_.note("Imported " + path.string() + ".");
    return merged;
  } catch (const std::exception& error) {
    messages_.error(error.what());
    return std::nullopt;
  }
}

Id skyOf(const Scene& scene) {
  const std::vector<bool> visible = hierarchyVisibility(scene);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Light* light = std::get_if<Light>(&scene.objects[i].content);
    if (visible[i] && light && std::holds_alternative<EnvironmentLight>(light->kind))
      return scene.objects[i].id;
  }
  return Id::none;
}

std::optional<Scene> ProjectFiles::withSky(const Document& document, Id light, const fs::path& image) {
  Scene scene = document.committed();
  if (light == Id::none) {
    edits::Added added =
        edits::addLight(std::move(scene), Light{.kind = EnvironmentLight{}, .intensity = 1.0f});
    scene = std::move(added.scene);
    light = added.id;
  }
  const Object* object = find(scene, light);
  const Light* found = object ? std::get_if<Light>(&object->content) : nullptr;
  if (!found || !std::holds_alternative<EnvironmentLight>(found->kind)) return std::nullopt;
  const fs::path folder = projectFolderOf(document.path());
  Light next = *found;
  std::get<EnvironmentLight>(next.kind).file = assetName(image, folder);
  scene = edits::setContent(std::move(scene), light, next);
  for (const AssetProblem& problem : assets_.load(scene, folder))
    problem.missing ? messages_.error(problem.message) : messages_.warning(problem.message);
  const Light& loaded = std::get<Light>(find(scene, light)->content);
  if (!std::get<EnvironmentLight>(loaded.kind).image) return std::nullopt;
  return scene;
}

bool ProjectFiles::save(Document& document, const fs::path& path) {
  try {
    // Saved elsewhere, the files that it names are the same ones.
    const fs::path from = projectFolderOf(document.path()), to = projectFolderOf(path);
    if (from != to) document.apply(withAssetsNamedFrom(document.committed(), from, to), "Save elsewhere");
    plugins_.exportScene(document.committed(), path);
    document.markSaved(path);
    recent_.add(path);
    messages_.note("Saved " + path.string() + ".");
    return true;
  } catch (const std::exception& error) {
    messages_.error(error.what());
    return false;
  }
}

std::optional<fs::path> ProjectFiles::rescue(const Document& document) {
  const std::optional<fs::path> folder = stateFolder();
  if (!folder || !document.unsaved()) return std::nullopt;
  try {
    fs::create_directories(*folder);
    const fs::path stem = document.path().empty() ? "untitled" : document.path().stem();
    const fs::path path = *folder / ("rescued-" + stem.string() + "-" + std::to_string(getpid()) + ".srad");
    plugins_.exportScene(withAssetsNamedFrom(document.committed(), projectFolderOf(document.path()), {}),
                         path);
    return path;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace steradian::ui
