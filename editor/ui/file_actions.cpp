// SPDX-License-Identifier: MIT
// New, open, save, export and quit, with the question before something is lost.
#include <ctime>
#include <utility>

#include "editor/assets.hpp"
#include "editor/tonemapping.hpp"
#include "editor/ui/application.hpp"
#include "editor/ui/placement.hpp"

namespace steradian::ui {

namespace fs = std::filesystem;

void Application::runFileCommand(Command command) {
  switch (command) {
    case Command::newScene:
      guarded([this] { show(Document(startScene())); });
      break;
    case Command::open:
      guarded([this] { browseToOpen(); });
      break;
    case Command::import:
      browse({"Import", "Import", false, files_.addExtensions()}, projectFolderOf(document_.path()),
             [this](const fs::path& path) { importFile(path); });
      break;
    case Command::save:
      save();
      break;
    case Command::saveAs:
      saveAs();
      break;
    case Command::exportStill:
      if (job_)
        messages_.note("One export runs already; wait for it or cancel it.");
      else
        export_.open(document_.scene(), document_.path());
      break;
    case Command::screenshot:
      screenshotWanted_ = true;
      break;
    case Command::quit:
      if (loading_.modal()) loading_.cancel();
      guarded([this] { quit_ = true; });
      break;
    default:
      break;
  }
}

void Application::guarded(std::function<void()> next) {
  if (document_.unsaved())
    unsaved_.ask(document_.path().empty() ? "This scene" : document_.path().filename().string(),
                 std::move(next));
  else
    next();
}

void Application::answered(UnsavedDialog::Answer answer) {
  if (answer == UnsavedDialog::Answer::save) return save();
  if (auto next = unsaved_.takeNext()) next();
}

void Application::save() {
  if (document_.path().empty()) return saveAs();
  if (!files_.save(document_, document_.path())) return unsaved_.drop();
  if (auto next = unsaved_.takeNext()) next();
}

void Application::browse(FileBrowser::Purpose purpose, const fs::path& start,
                         std::function<void(const fs::path&)> chosen) {
  chosen_ = std::move(chosen);
  browser_.open(std::move(purpose), start);
}

void Application::saveAs() {
  const fs::path start = document_.path().empty() ? fs::path("untitled.srad") : document_.path();
  browse({"Save as", "Save", true, files_.saveExtensions()}, start, [this](const fs::path& path) {
    if (!files_.save(document_, path)) return unsaved_.drop();
    if (auto next = unsaved_.takeNext()) next();
  });
}

void Application::browseToOpen() {
  browse({"Open", "Open", false, files_.importExtensions()}, document_.path().parent_path(),
         [this](const fs::path& path) { openFile(path); });
}

void Application::startExport(const StillSettings& settings) {
  try {
    const Scene& scene = document_.committed();
    const CameraView view = settings.fromView ? viewOf(view_, scene) : cameraView(scene);
    job_.emplace(device_, cache_, scene, view, tonemapperFor(plugins_, scene.display), settings);
  } catch (const std::exception& error) {
    messages_.error(error.what());
  }
}

void Application::saveScreenshot() {
  try {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    char name[48];
    std::strftime(name, sizeof name, "steradian-%Y%m%d-%H%M%S.png", &local);
    const Image shot = presenter_.screenshot();
    plugins::ImageToSave image{shot.width, shot.height, shot.pixels.data(), shot.pixels.data(), {}};
    plugins_.exportImage(image, name);
    messages_.note("Wrote " + fs::absolute(name).string() + ".");
  } catch (const std::exception& error) {
    messages_.error(error.what());
  }
}

}  // namespace steradian::ui
