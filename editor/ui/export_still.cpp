// SPDX-License-Identifier: MIT
// What the export asks, and what it tells while it runs.
#include "editor/ui/export_still.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

#include "editor/ui/numbers.hpp"
#include "editor/ui/style.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace fs = std::filesystem;

void ExportDialog::open(const Scene& scene, const fs::path& project) {
  opening_ = true;
  confirmOverwrite_ = false;
  settings_.size = {scene.render.width, scene.render.height};
  if (!pathText_.empty()) return;
  std::error_code failed;
  const fs::path folder = project.empty() ? fs::current_path(failed) : project.parent_path();
  const fs::path stem = project.empty() ? fs::path("untitled") : project.stem();
  pathText_ = (folder / stem).string() + ".png";
}

void ExportDialog::setPath(const fs::path& path) {
  pathText_ = path;
  opening_ = true;
  confirmOverwrite_ = true;  // the file browser has asked
}

std::string ExportDialog::problem() const {
  const fs::path path = pathText_;
  std::error_code failed;
  std::string extension = path.extension();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  if (extension != ".png" && extension != ".exr") return "The name must end in .png or .exr.";
  if (!path.has_parent_path()) return {};
  return fs::is_directory(path.parent_path(), failed) ? "" : path.parent_path().string() + " is no folder.";
}

void ExportDialog::drawFields(Ui& ui, Answer& answer) {
  Fields fields(ui, "export");
  NumberField size{.name = "Width",
                   .help = "Of the picture.",
                   .unit = " px",
                   .minimum = 1,
                   .maximum = 16384,
                   .speed = 2,
                   .decimals = 0};
  fields.integer(size, settings_.size.width);
  size.name = "Height";
  fields.integer(size, settings_.size.height);
  int view = settings_.fromView ? 1 : 0;
  if (fields.choice("Camera", "The scene's active camera, or where you look from now.",
                    {"Active camera", "This view"}, view))
    settings_.fromView = view == 1;
  int until = settings_.byError ? 1 : 0;
  if (fields.choice("Until", "A fixed number of samples, or until the picture is good enough.",
                    {"Samples", "Error target"}, until))
    settings_.byError = until == 1;
  if (settings_.byError)
    fields.number({.name = "Error target",
                   .help = "Relative root mean square error of the picture.",
                   .unit = " %",
                   .minimum = 0.01,
                   .maximum = 50.0,
                   .decimals = 2,
                   .logarithmic = true,
                   .standard = 1.0},
                  settings_.errorPercent);
  else
    fields.integer({.name = "Samples",
                    .help = "Per pixel. Four times as many halve the error, or better.",
                    .minimum = 1,
                    .maximum = 1e6,
                    .decimals = 0,
                    .logarithmic = true,
                    .standard = 256},
                   settings_.samples);
  fields.begin("File", "EXR keeps scene-linear radiance; PNG is what the viewport shows.");
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ui.px(76));
  if (ImGui::InputText("##file", &pathText_)) confirmOverwrite_ = false;
  ui.mark("export/File");
  ImGui::SameLine();
  answer.browse = button(ui, "Browse", "export/Browse", nullptr, -FLT_MIN);
  ImGui::PopID();
}

ExportDialog::Answer ExportDialog::draw(Ui& ui) {
  Answer answer;
  if (std::exchange(opening_, false)) ImGui::OpenPopup("Export still");
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.45f}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(ui.px(520), screen.x * 0.9f), 0});
  bool shown = true;
  if (!ImGui::BeginPopupModal("Export still", &shown, ImGuiWindowFlags_NoResize)) return answer;
  drawFields(ui, answer);
  std::error_code failed;
  const std::string wrong = problem();
  const bool exists = wrong.empty() && !confirmOverwrite_ && fs::exists(pathText_, failed);
  ImGui::TextColored(ImColor(wrong.empty() ? color::kWarning : color::kError), "%s",
                     exists ? "This file exists and will be replaced." : wrong.c_str());
  ImGui::BeginDisabled(!wrong.empty());
  if (mainButton(ui, exists ? "Replace" : "Render", "export/Render", ui.px(110))) {
    settings_.path = pathText_;
    answer.start = settings_;
  }
  ImGui::EndDisabled();
  ImGui::SameLine();
  const bool cancel = button(ui, "Cancel", "export/Cancel", nullptr, ui.px(110));
  if (cancel || answer.start || answer.browse || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
    ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return answer;
}

JobWish drawJob(Ui& ui, const StillJob& job, ImVec2 bottomRight) {
  beginCornerWindow(ui, "export progress", bottomRight);
  ImGui::Text("Rendering %s", job.settings().path.filename().c_str());
  ImGui::ProgressBar(float(job.fraction()), {-FLT_MIN, ui.px(18)});
  const auto remaining = job.remainingSeconds();
  std::string line = countText(job.stats().samples) + " samples";
  if (job.stats().error.valid) line += ", error " + percent(job.stats().error.relRmse);
  line += remaining ? ", " + duration(*remaining) + " left" : ", estimating";
  dimText(line);
  JobWish wish = JobWish::goOn;
  if (button(ui, "Save now", "job/Save now", "Stop here and write the file as it is"))
    wish = JobWish::keepPartial;
  ImGui::SameLine();
  if (button(ui, "Cancel", "job/Cancel", "Stop and write nothing")) wish = JobWish::cancel;
  ImGui::End();
  return wish;
}

}  // namespace steradian::ui
