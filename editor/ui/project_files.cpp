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

/// A model is opened with a camera and light that it may lack; a project is meant as it is.
void addFirstView(ReadScene& read) {
  FirstView first = withFirstView(std::move(read.scene));
  read.scene = std::move(first.scene);
  if (!first.added.empty())
    read.remarks.push_back({Messages::Kind::note, read.path.filename().string() +
                                                      " has none of its own: added " + first.added + "."});
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

ReadScene ProjectFiles::read(const fs::path& given, LoadStatus& status, const std::optional<fs::path>& into) {
  ReadScene read{fs::absolute(fileIn(given)).lexically_normal(), {}, {}};
  const plugins::Progress progress{[&](double fraction) { status.report(fraction); },
                                   [&] { return status.cancelled(); },
                                   [&](const std::string& line) {
                                     read.remarks.push_back({Messages::Kind::note, line});
                                   }};
  status.enter("Reading", 0.0, 0.6);
  plugins::ImportResult result = plugins_.importScene(read.path, progress);
  for (const plugins::ImportReport::Line& line : result.report.notKept)
    read.remarks.push_back(
        {Messages::Kind::warning, read.path.filename().string() + ": " + line.what + ": " + line.why});
  // Named anew first: what is decoded then keeps its identity.
  const fs::path here = read.path.parent_path();
  const fs::path home = into ? *into : isProject(read.path) ? here : fs::path();
  read.scene = std::move(result.scene);
  if (home != here) read.scene = withAssetsNamedFrom(std::move(read.scene), here, home);
  status.enter("Decoding images", 0.6, 0.75);
  for (const AssetProblem& problem : assets_.load(read.scene, home))
    read.remarks.push_back(problem.missing
                               ? Remark{Messages::Kind::error,
                                        problem.message + "; until then the sky shows its gradient alone."}
                               : Remark{Messages::Kind::warning, problem.message});
  if (!into && !isProject(read.path)) addFirstView(read);
  return read;
}

ReadSky ProjectFiles::readSky(const fs::path& path) {
  ReadSky read{fs::absolute(path).lexically_normal(), nullptr, {}};
  std::vector<AssetProblem> problems;
  read.image = assets_.image(read.path, problems);
  for (AssetProblem& problem : problems)
    read.remarks.push_back({Messages::Kind::warning, std::move(problem.message)});
  return read;
}

void ProjectFiles::tell(const std::vector<Remark>& remarks) {
  for (const auto& [kind, text] : remarks) messages_.add(kind, text);
}

void ProjectFiles::failed(const fs::path& path, const std::string& reason) {
  messages_.error(reason);
  recent_.remove(path);
}

Document ProjectFiles::open(ReadScene read) {
  tell(read.remarks);
  recent_.add(read.path);
  messages_.note("Opened " + read.path.string() + ".");
  if (isProject(read.path)) return Document(std::move(read.scene), read.path);
  // What cannot be written back is a new project.
  Document imported(std::move(read.scene));
  imported.markUnsaved();
  return imported;
}

edits::Merged ProjectFiles::import(const Document& document, const ReadScene& read) {
  edits::Merged merged = edits::merge(document.committed(), read.scene, read.path.stem().string());
  tell(read.remarks);
  messages_.note("Imported " + read.path.string() + ".");
  return merged;
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

std::optional<Scene> ProjectFiles::withSky(const Document& document, Id light, const ReadSky& read) {
  Scene scene = document.committed();
  if (light == Id::none) {
    edits::Added added =
        edits::addLight(std::move(scene), Light{.kind = EnvironmentLight{}, .intensity = 1.0f});
    scene = std::move(added.scene);
    light = added.id;
  }
  const Object* object = find(scene, light);
  const Light* found = object ? std::get_if<Light>(&object->content) : nullptr;
  if (!found || !std::holds_alternative<EnvironmentLight>(found->kind)) {
    messages_.warning(read.path.string() + ": the light that it was chosen for is gone.");
    return std::nullopt;
  }
  tell(read.remarks);
  Light next = *found;
  auto& sky = std::get<EnvironmentLight>(next.kind);
  sky.file = assetName(read.path, projectFolderOf(document.path()));
  sky.image = read.image;
  return edits::setContent(std::move(scene), light, next);
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
