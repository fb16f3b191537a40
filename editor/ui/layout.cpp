// SPDX-License-Identifier: MIT
// Panel rectangles and the handles between them.
#include "editor/ui/layout.hpp"

#include <algorithm>
#include <cmath>

namespace steradian::ui {

namespace {

constexpr float kGap = 2.0f;         // design pixels between panels
constexpr float kHandleGrip = 7.0f;  // design pixels that react to the mouse

}  // namespace

Layout PanelLayout::compute(const Ui& ui, const ViewOptions& options, float menuHeight) const {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float gap = std::max(1.0f, std::round(ui.px(kGap)));
  const float status = std::round(ImGui::GetFrameHeight() + ui.px(4));
  const float top = menuHeight, bottom = std::max(top + 1, screen.y - status - gap);
  const float most = screen.x * 0.4f;
  const float left = options.outliner ? std::round(std::min(ui.px(left_), most)) : 0.0f;
  const float right = options.inspector ? std::round(std::min(ui.px(right_), most)) : 0.0f;
  const float low = options.messages ? std::round(std::min(ui.px(bottom_), (bottom - top) * 0.5f)) : 0.0f;
  const float x0 = left > 0 ? left + gap : 0.0f, x1 = right > 0 ? screen.x - right - gap : screen.x;
  const float y1 = low > 0 ? bottom - low - gap : bottom;
  Layout layout;
  layout.outliner = {{0, top}, {left, bottom - top}};
  layout.inspector = {{screen.x - right, top}, {right, bottom - top}};
  layout.viewport = {{x0, top}, {std::max(1.0f, x1 - x0), std::max(1.0f, y1 - top)}};
  layout.messages = {{x0, bottom - low}, {std::max(1.0f, x1 - x0), low}};
  layout.status = {{0, bottom + gap}, {screen.x, status}};
  return layout;
}

void PanelLayout::handle(Ui& ui, const char* name, ViewRect rect, bool vertical, float sign, float& size,
                         float minimum) {
  ImGui::SetNextWindowPos(rect.min);
  ImGui::SetNextWindowSize(rect.size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav);
  ImGui::InvisibleButton("grip", rect.size);
  ui.mark(name);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive())
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  if (ImGui::IsItemActive()) {
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    size = std::max(minimum, size + sign * (vertical ? delta.x : delta.y) / ui.scale);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

void PanelLayout::handles(Ui& ui, const ViewOptions& options, const Layout& layout) {
  const float grip = ui.px(kHandleGrip), half = grip * 0.5f;
  const ViewRect& view = layout.viewport;
  const float height = layout.outliner.size.y;
  if (options.outliner)
    handle(ui, "handle/left", {{view.min.x - half, view.min.y}, {grip, height}}, true, 1, left_, 140);
  if (options.inspector)
    handle(ui, "handle/right", {{view.min.x + view.size.x - half, view.min.y}, {grip, height}}, true, -1,
           right_, 220);
  if (options.messages)
    handle(ui, "handle/bottom", {{view.min.x, view.min.y + view.size.y - half}, {view.size.x, grip}}, false,
           -1, bottom_, 56);
}

void beginPanel(const char* name, const ViewRect& rect, bool seeThrough) {
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                           ImGuiWindowFlags_NoNavInputs;
  if (seeThrough) flags |= ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::SetNextWindowPos(rect.min);
  ImGui::SetNextWindowSize(rect.size);
  ImGui::Begin(name, nullptr, flags);
}

}  // namespace steradian::ui
