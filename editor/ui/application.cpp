// SPDX-License-Identifier: MIT
// Starting and ending the editor.
#include "editor/ui/application.hpp"

#include <cstdio>
#include <cstdlib>

#include "editor/ui/placement.hpp"

namespace steradian {

int runEditor(const EditorOptions& options) {
  return ui::Application(options).run();
}

namespace ui {

namespace {

constexpr Extent kWindowSize{1360, 820};  // design pixels
constexpr std::chrono::seconds kPatience{10};

std::shared_ptr<gpu::Device> openFor(const SurfaceSource& surface, const EditorOptions& options) {
  return openDevice({options.device, options.validation, &surface});
}

bool validationWanted(const EditorOptions& options) {
  const char* wanted = std::getenv("STERADIAN_VALIDATION");
  return options.validation || (wanted && std::string(wanted) == "1");
}

}  // namespace

Application::Application(const EditorOptions& options)
    : window_(kWindowSize, "Steradian"),
      surface_(makeSurface(window_)),
      device_(openFor(surface_, options)),
      description_(describe(*device_)),
      plugins_(plugins::defaultSearchPath(options.pluginPath)),
      files_(plugins_, messages_),
      presenter_(device_, window_.framebuffer(), PresentMode::fifo),
      live_(device_, cache_, plugins_, messages_),
      imgui_(window_, presenter_.handles()),
      reportValidation_(validationWanted(options)) {
  reportPlugins();
  starting_ = !options.file.empty();
  if (starting_)
    openFile(options.file);
  else
    show(Document(startScene()));
}

Application::~Application() = default;

void Application::reportPlugins() {
  for (const plugins::PluginFile& file : plugins_.files())
    if (!file.loaded) messages_.warning("Plugin " + file.path.string() + " was not loaded: " + file.reason);
}

void Application::show(Document document) {
  starting_ = false;
  loading_.cancel();  // a sky that was meant for the other document
  document_ = std::move(document);
  pendingName_.clear();
  outliner_ = {};
  inspector_ = {};
  view_.throughCamera = Id::none;
  const Scene& scene = document_.scene();
  const std::optional<Bounds> bounds = boundsOf(scene);
  const CameraView start = cameraView(scene);
  const glm::dvec3 eye(start.worldFromCamera[3]);
  view_.orbit.lookAs(start, bounds ? std::max(glm::length(bounds->center() - eye), 1e-3) : 5.0);
}

int Application::run() {
  try {
    while (!quit_) frame();
  } catch (const Error& error) {
    // The device is gone and the window cannot be drawn any more: keep the work, then say so.
    const auto rescued = files_.rescue(document_);
    std::fprintf(stderr, "steradian: %s\n", error.what());
    if (rescued) std::fprintf(stderr, "steradian: your unsaved work is in %s\n", rescued->c_str());
    return int(error.code());
  }
  finish();
  return int(ExitCode::ok);
}

void Application::finish() {
  job_.reset();
  frameTimes_.write();
  if (reportValidation_)
    std::fprintf(stderr, "steradian: %d validation messages\n", validationMessages(*device_));
  if (loading_.stopWithin(kPatience)) return;
  // A plugin that never comes back must not keep the program: its work is nobody's any more.
  std::fprintf(stderr, "steradian: ended although an importer still runs\n");
  std::_Exit(int(ExitCode::ok));
}

std::string Application::systemInformation() const {
  std::string text = "Device: " + description_.name + " (" + description_.type +
                     ")\nDriver: " + description_.driver + "\nVulkan: " + description_.api +
                     "\nQueues: " + description_.queues + "\nPlugins: ";
  int loaded = 0;
  for (const plugins::PluginFile& file : plugins_.files()) loaded += file.loaded;
  return text + std::to_string(loaded) + " of " + std::to_string(plugins_.files().size()) + " loaded";
}

}  // namespace ui
}  // namespace steradian
