// SPDX-License-Identifier: MIT
// Name, step, share and a button.
#include "editor/ui/loading_view.hpp"

#include "editor/ui/style.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

constexpr double kBlink = 0.2;  // seconds
constexpr const char* kPopup = "Loading";

bool drawContent(Ui& ui, const Loading::View& view) {
  ImGui::TextUnformatted(view.name.c_str());
  ImGui::ProgressBar(float(view.fraction), {-FLT_MIN, ui.px(18)});
  ui.mark("loading/Progress");
  std::string line = view.step;
  if (view.waiting > 0) line += ", " + std::to_string(view.waiting) + " more to come";
  dimText(line);
  return button(ui, "Cancel", "loading/Cancel", "Stop reading; the scene stays as it is", ui.px(110));
}

bool drawModal(Ui& ui, const Loading::View& view, bool wanted) {
  if (wanted && !ImGui::IsPopupOpen(kPopup)) ImGui::OpenPopup(kPopup);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.45f}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({ui.px(360), 0});
  if (!ImGui::BeginPopupModal(kPopup, nullptr, ImGuiWindowFlags_NoResize)) return false;
  bool cancelled = false;
  if (wanted)
    cancelled = drawContent(ui, view) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  else
    ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return cancelled;
}

bool drawInCorner(Ui& ui, const Loading::View& view, ImVec2 bottomRight) {
  beginCornerWindow(ui, "loading in the background", bottomRight);
  const bool cancelled = drawContent(ui, view);
  ImGui::End();
  return cancelled;
}

}  // namespace

bool drawLoading(Ui& ui, const Loading& loading, ImVec2 bottomRight) {
  const Loading::View view = loading.view();
  const bool shown = loading.busy() && view.seconds > kBlink;
  bool cancelled = drawModal(ui, view, shown && loading.modal());
  if (shown && !loading.modal()) cancelled = drawInCorner(ui, view, bottomRight);
  return cancelled;
}

}  // namespace steradian::ui
