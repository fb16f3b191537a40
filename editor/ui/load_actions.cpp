// SPDX-License-Identifier: MIT
// Opening, importing and skies: what the worker reads, and what the document makes of it.
#include "editor/ui/application.hpp"
#include "editor/ui/placement.hpp"

namespace steradian::ui {

namespace fs = std::filesystem;

namespace {

std::string nameOf(const fs::path& path) {
  return path.has_filename() ? path.filename().string() : path.string();
}

}  // namespace

std::function<void(const std::string&)> Application::dropping(const fs::path& path) {
  return [this, path](const std::string& reason) {
    if (reason.empty())
      messages_.note("Cancelled " + nameOf(path) + "; nothing has changed.");
    else
      files_.failed(path, reason);
    if (starting_) show(Document(startScene()));
  };
}

void Application::prepare(const Scene& scene, LoadStatus& status, Extent film) try {
  status.enter("Building", 0.75, 1.0);
  OrbitView view;  // as the scene will be looked at
  view.lookAs(cameraView(scene), 1.0);
  live_.renderer().prepare(scene, view.view(), film, [&](double fraction) {
    status.report(fraction);
    return !status.cancelled();
  });
} catch (const Error&) {
  // What the device cannot take is told when it is shown; the document may still be edited and saved.
}

void Application::openFile(const fs::path& path) {
  const auto read = [this, path, film = filmSize()](LoadStatus& status) -> Taking {
    auto scene = std::make_shared<ReadScene>(files_.read(path, status));
    prepare(scene->scene, status, film);
    return [this, scene] { show(files_.open(std::move(*scene))); };
  };
  loading_.start({nameOf(path), true, read, dropping(path)});
}

void Application::carryOut(const ImportFiles& request) {
  for (const fs::path& path : request.paths) importFile(path);
}

void Application::importFile(const fs::path& path) {
  if (files_.isSky(path)) return readSky(path, std::nullopt);
  const auto read = [this, path, into = projectFolderOf(document_.path()), base = document_.snapshot(),
                     film = filmSize()](LoadStatus& status) -> Taking {
    const auto scene = std::make_shared<const ReadScene>(files_.read(path, status, into));
    prepare(edits::merge(*base, scene->scene, {}).scene, status, film);
    return [this, scene] { takeImported(*scene); };
  };
  loading_.start({nameOf(path), true, read, dropping(path)});
}

void Application::takeImported(const ReadScene& read) {
  edits::Merged merged = files_.import(document_, read);
  edit(std::move(merged.scene), "Import " + read.path.filename().string());
  document_.selectOnly(merged.group);
  frameObjects(&merged.objects);
}

/// `light` none = a new one; not given = the one that shines when the file is read.
void Application::readSky(const fs::path& path, std::optional<Id> light) {
  const auto read = [this, path, light](LoadStatus& status) -> Taking {
    status.enter("Reading", 0.0, 0.5);
    const auto sky = std::make_shared<const ReadSky>(files_.readSky(path));
    status.enter("Building", 0.5, 1.0);
    if (!status.cancelled()) cache_->skyOf(sky->image);
    return [this, sky, light] {
      const Id target = light ? *light : skyOf(document_.committed());
      if (auto next = files_.withSky(document_, target, *sky)) edit(std::move(*next), "Choose sky");
    };
  };
  loading_.start({nameOf(path), false, read, dropping(path)});
}

void Application::carryOut(const ChooseSky& request) {
  const fs::path start = projectFolderOf(document_.path());
  browse({"Choose a sky", "Choose", false, {".exr", ".hdr"}}, start,
         [this, light = request.light](const fs::path& path) { readSky(path, light); });
}

void Application::carryOut(const CancelLoading&) {
  loading_.cancel();
}

void Application::takeLoaded() try { loading_.advance(); } catch (const std::exception& error) {
  messages_.error(error.what());
}

/// While a file is read that replaces or joins the scene, nothing else may change it.
void Application::ignoreEdits() {
  edit_.reset();
  click_.reset();
  std::erase_if(requests_, [this](const Request& request) {
    if (std::holds_alternative<OpenFile>(request) || std::holds_alternative<ImportFiles>(request))
      messages_.note("Wait until " + loading_.view().name + " is read, then drop the file again.");
    const auto* run = std::get_if<Run>(&request);
    return !std::holds_alternative<CancelLoading>(request) && !(run && run->command == Command::quit);
  });
}

}  // namespace steradian::ui
