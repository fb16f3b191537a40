// SPDX-License-Identifier: MIT
// One line of figures, each with its meaning in the tooltip.
#include "editor/ui/status_bar.hpp"

#include "editor/ui/widgets.hpp"

namespace steradian::ui {

void statusBar(Ui& ui, const StatusInput& input) {
  const std::vector<StatusFigure> figures = statusFigures(input);
  const float gap = ui.px(18);
  const std::vector<std::string> shown =
      fittedForms(figures, ImGui::GetContentRegionAvail().x, gap,
                  [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; });
  ImGui::AlignTextToFramePadding();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (shown[i].empty()) continue;
    if (i > 0) ImGui::SameLine(0, gap);
    ImGui::PushStyleColor(ImGuiCol_Text, figures[i].tint);
    ImGui::TextUnformatted(shown[i].c_str());
    ImGui::PopStyleColor();
    ui.mark("status/" + figures[i].label);
    if (!ImGui::IsItemHovered()) continue;
    // What has no room is told with the meaning.
    const std::string& full = figures[i].forms.front();
    tooltip(((shown[i] == full ? "" : full + "\n") + figures[i].help).c_str());
  }
}

}  // namespace steradian::ui
