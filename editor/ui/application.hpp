// SPDX-License-Identifier: MIT
// The running editor: owns its parts and joins them once per frame.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/document.hpp"
#include "editor/ui/app.hpp"
#include "editor/ui/dialogs.hpp"
#include "editor/ui/export_still.hpp"
#include "editor/ui/file_browser.hpp"
#include "editor/ui/frame_times.hpp"
#include "editor/ui/imgui_vulkan.hpp"
#include "editor/ui/inspector.hpp"
#include "editor/ui/layout.hpp"
#include "editor/ui/live_render.hpp"
#include "editor/ui/loading.hpp"
#include "editor/ui/menu.hpp"
#include "editor/ui/outliner.hpp"
#include "editor/ui/project_files.hpp"
#include "editor/ui/viewport.hpp"
#include "editor/window.hpp"
#include "renderer/scene_cache.hpp"

namespace steradian::ui {

class Application {
 public:
  explicit Application(const EditorOptions& options);
  ~Application();
  int run();

 private:
  // application.cpp: the life of the program
  void reportPlugins();
  void show(Document document);
  void finish();
  std::string systemInformation() const;

  // frame.cpp: one frame
  void frame();
  void takeWindowEvents();
  void drawInterface(Ui& ui);
  void drawMenuBar(Ui& ui);
  void drawPanels(Ui& ui);
  void drawViewport(Ui& ui);
  void drawDialogs(Ui& ui);
  void settleEdit();
  void updatePicture();
  void advanceExport();
  double waitSeconds() const;
  bool resting() const;
  ViewRect picture() const { return pictureRect(view_, document_.scene(), layout_.viewport); }
  Extent filmSize() const;

  // actions.cpp: what requests do, between frames
  void carryOutRequests();
  void carryOut(const Run& request);
  void carryOut(const OpenFile& request);
  void carryOut(const ImportFiles& request);
  void carryOut(const AddObject& request);
  void carryOut(const Select& request);
  void carryOut(const LookThrough& request);
  void carryOut(const ChooseSky& request);
  void carryOut(const CancelLoading& request);
  void runFileCommand(Command command);
  void runEditCommand(Command command);
  void runViewCommand(Command command);
  void edit(Scene scene, std::string name) { document_.apply(std::move(scene), std::move(name)); }
  void clicked(const Click& click);
  void toggleVisible();
  void frameObjects(const Selection* objects);
  void toggleLookThrough();
  void moveCameraToView();

  // file_actions.cpp: what touches files
  void guarded(std::function<void()> next);  // asks first when something is unsaved
  void answered(UnsavedDialog::Answer answer);
  void save();
  void browse(FileBrowser::Purpose purpose, const std::filesystem::path& start,
              std::function<void(const std::filesystem::path&)> chosen);
  void saveAs();
  void browseToOpen();
  void startExport(const StillSettings& settings);
  void saveScreenshot();

  // load_actions.cpp: what is read on the worker
  void openFile(const std::filesystem::path& path);
  void importFile(const std::filesystem::path& path);
  void takeImported(const ReadScene& read);
  void readSky(const std::filesystem::path& path, std::optional<Id> light);
  void prepare(const Scene& scene, LoadStatus& status, Extent film);  // on the worker
  std::function<void(const std::string&)> dropping(const std::filesystem::path& path);
  void takeLoaded();
  void ignoreEdits();

  Window window_;
  SurfaceSource surface_;
  std::shared_ptr<gpu::Device> device_;
  DeviceDescription description_;
  plugins::PluginHost plugins_;
  Messages messages_;
  ProjectFiles files_;
  Presenter presenter_;
  std::shared_ptr<SceneCache> cache_ = std::make_shared<SceneCache>();
  LiveRender live_;
  ImguiVulkan imgui_;

  Document document_;
  ViewState view_;
  ViewOptions options_;
  PanelLayout panels_;
  Layout layout_;
  Labels labels_ = Labels::fromEnvironment();
  OutlinerState outliner_;
  InspectorState inspector_;
  FileBrowser browser_;
  UnsavedDialog unsaved_;
  InfoDialogs info_;
  ExportDialog export_;
  std::optional<StillJob> job_;  // the export that runs
  JobWish jobWish_ = JobWish::goOn;
  std::vector<Request> requests_;
  std::optional<Edit> edit_;                                  // of this frame
  std::string pendingName_;                                   // of the preview that runs
  std::optional<Click> click_;                                // of this frame
  std::function<void(const std::filesystem::path&)> chosen_;  // what the file browser is for
  bool addMenuWanted_ = false, paused_ = false, quit_ = false, screenshotWanted_ = false;
  bool reportValidation_ = false;
  bool starting_ = false;  // the file of the command line is still being read: there is no scene to show
  FrameTimes frameTimes_ = FrameTimes::fromEnvironment();
  Loading loading_{Window::wake};  // last: its worker ends before what it uses
};

}  // namespace steradian::ui
