// SPDX-License-Identifier: MIT
// One frame: events, panels, edits, requests, samples, picture.
#include <imgui_internal.h>

#include <cmath>

#include "editor/ui/application.hpp"
#include "editor/ui/loading_view.hpp"
#include "editor/ui/numbers.hpp"
#include "editor/ui/shortcuts.hpp"
#include "editor/ui/status_bar.hpp"
#include "renderer/convergence.hpp"

namespace steradian::ui {

namespace {

constexpr double kTraceBudgetMs = 20.0;
constexpr double kExportBudgetMs = 25.0;       // while a person works
constexpr double kIdleExportBudgetMs = 100.0;  // while nobody touches anything: frames cost the export time
constexpr double kRestingWait = 0.05;          // seconds between frames when nothing moves
constexpr double kLoadingWait = 0.15;          // while a person waits for a file: the cores are for that

bool touched() {
  const ImGuiIO& io = ImGui::GetIO();
  return io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0 || ImGui::IsAnyMouseDown() ||
         ImGui::IsAnyItemActive();
}

}  // namespace

bool Application::resting() const {
  return live_.resting(std::uint64_t(options_.sampleLimit));
}

double Application::waitSeconds() const {
  if (loading_.modal() && !job_) return kLoadingWait;
  const bool working = job_ || (!paused_ && !resting());
  if (window_.framebuffer() == Extent{}) return job_ ? 0.0 : 0.1;
  return working ? 0.0 : kRestingWait;
}

void Application::takeWindowEvents() {
  const std::vector<std::filesystem::path> dropped = window_.takeDropped();
  Ui ui{window_.scale().units, labels_, requests_};
  if (!dropped.empty() && files_.isProject(dropped.front()))
    ui.ask(OpenFile{dropped.front()});
  else if (!dropped.empty())
    ui.ask(ImportFiles{dropped});
  if (window_.takeCloseRequest()) ui.ask(Command::quit);
  imgui_.setScale(window_.scale());
}

void Application::frame() {
  window_.poll(waitSeconds());
  frameTimes_.begin();
  takeWindowEvents();
  imgui_.beginFrame();
  labels_.begin();
  edit_.reset();
  click_.reset();
  Ui ui{window_.scale().units, labels_, requests_};
  try {
    drawInterface(ui);
  } catch (const std::exception& error) {
    // ImGui aborts on an open Begin: close what is open, tell, and go on with the scene as it was.
    ImGui::ErrorCheckEndFrameRecover(nullptr);
    messages_.error(error.what());
  }
  const bool held = ImGui::IsAnyItemActive();
  imgui_.endFrame();
  labels_.end();

  if (loading_.modal()) ignoreEdits();
  settleEdit();
  if (!held && document_.previewing()) document_.commit(pendingName_);
  carryOutRequests();
  takeLoaded();
  window_.setTitle(document_.title() + " - Steradian");
  advanceExport();
  updatePicture();
  frameTimes_.end();
}

void Application::settleEdit() {
  if (!edit_) return;
  pendingName_ = edit_->name;
  document_.preview(std::move(edit_->scene));
}

void Application::drawInterface(Ui& ui) {
  shortcuts(ui, window_.takeKeyPresses());
  drawMenuBar(ui);
  layout_ = panels_.compute(ui, options_, ImGui::GetFrameHeight());
  drawViewport(ui);
  drawPanels(ui);
  panels_.handles(ui, options_, layout_);
  drawDialogs(ui);
}

void Application::drawMenuBar(Ui& ui) {
  if (!ImGui::BeginMainMenuBar()) return;
  const MenuInput input{document_, files_.recent().paths(), paused_, view_.throughCamera != Id::none};
  menuBar(ui, input, options_);
  view_.overlay = options_.overlay;
  ImGui::EndMainMenuBar();
}

void Application::drawPanels(Ui& ui) {
  const auto keep = [this](std::optional<Edit> next) {
    if (next) edit_ = std::move(next);
  };
  if (options_.outliner) {
    beginPanel("outliner", layout_.outliner);
    keep(outliner(ui, outliner_, document_));
    ImGui::End();
  }
  if (options_.inspector) {
    beginPanel("inspector", layout_.inspector);
    const Scene& scene = document_.scene();
    keep(inspector(
        ui, inspector_,
        {scene, document_, viewOf(view_, scene), view_.throughCamera, plugins_, *cache_, live_.stats()}));
    ImGui::End();
  }
  if (options_.messages) {
    beginPanel("messages", layout_.messages);
    messages_.draw(ui);
    ImGui::End();
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(2)});
  beginPanel("status", layout_.status);
  const Goal goal{export_.errorTarget(), live_.measuredAt(), live_.secondsPerSample(),
                  std::uint64_t(options_.sampleLimit)};
  statusBar(ui, {description_, live_.stats(), goal, paused_, resting()});
  ImGui::End();
  ImGui::PopStyleVar();
}

void Application::drawViewport(Ui& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  beginPanel("viewport panel", layout_.viewport, true);
  click_ = viewport(ui, view_, document_, layout_.viewport);
  ImGui::End();
  ImGui::PopStyleVar();
}

void Application::drawDialogs(Ui& ui) {
  if (std::exchange(addMenuWanted_, false)) ImGui::OpenPopup("add menu");
  if (ImGui::BeginPopup("add menu")) {
    addMenuItems(ui);
    ImGui::EndPopup();
  }
  if (const auto answer = unsaved_.draw(ui)) answered(*answer);
  if (const auto path = browser_.draw(ui))
    if (auto chosen = std::exchange(chosen_, nullptr)) chosen(*path);
  const ExportDialog::Answer wanted = export_.draw(ui);
  if (wanted.browse)
    browse({"Export still", "Choose", true, {".png", ".exr"}}, document_.path().parent_path(),
           [this](const std::filesystem::path& path) { export_.setPath(path); });
  if (wanted.start) startExport(*wanted.start);
  info_.draw(ui, systemInformation());
  const ViewRect& view = layout_.viewport;
  const ImVec2 corner{view.min.x + view.size.x, view.min.y + view.size.y};
  if (drawLoading(ui, loading_, job_ ? ImVec2(corner.x, corner.y - ui.px(140)) : corner))
    ui.ask(CancelLoading{});
  if (!job_) return;
  const JobWish wish = drawJob(ui, *job_, corner);
  if (wish != JobWish::goOn) jobWish_ = wish;
}

Extent Application::filmSize() const {
  const float pixels = window_.scale().pixelsPerUnit;
  const ViewRect rect = picture();
  return {std::max(1, int(std::lround(rect.size.x * pixels))),
          std::max(1, int(std::lround(rect.size.y * pixels)))};
}

void Application::updatePicture() {
  const Extent framebuffer = window_.framebuffer();
  if (framebuffer == Extent{}) return;
  const Extent film = filmSize();
  if (!starting_) live_.show(document_.snapshot(), viewOf(view_, document_.scene()), film);
  // While a still is exported or a file is read the viewport only follows edits.
  const bool otherWork = job_ || loading_.modal();
  if (!paused_ && (!otherWork || live_.stats().samples == 0))
    live_.advance(kTraceBudgetMs, std::uint64_t(options_.sampleLimit));
  const float pixels = window_.scale().pixelsPerUnit;
  const ViewRect rect = picture();
  const PixelRect viewport{int(std::lround(rect.min.x * pixels)), int(std::lround(rect.min.y * pixels)),
                           film.width, film.height};
  presenter_.present(live_.renderer(), framebuffer, viewport,
                     [this](void* commandBuffer) { imgui_.draw(commandBuffer); });
  if (std::exchange(screenshotWanted_, false)) saveScreenshot();
}

void Application::advanceExport() {
  if (!job_) return;
  try {
    const JobWish wish = std::exchange(jobWish_, JobWish::goOn);
    const bool done =
        wish == JobWish::goOn ? job_->advance(touched() ? kExportBudgetMs : kIdleExportBudgetMs) : true;
    if (!done) return;
    if (wish == JobWish::cancel) {
      messages_.note("Export cancelled; nothing was written.");
    } else {
      job_->write(plugins_, description_.name);
      messages_.note("Wrote " + job_->settings().path.string() + " with " + countText(job_->stats().samples) +
                     " samples in " + duration(job_->seconds()) + ".");
      for (const std::string& doubt : doubtsAbout(job_->stats())) messages_.warning(doubt);
    }
  } catch (const std::exception& error) {
    messages_.error(error.what());
  }
  job_.reset();
}

}  // namespace steradian::ui
