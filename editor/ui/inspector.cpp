// SPDX-License-Identifier: MIT
// The inspector's tabs.
#include "editor/ui/inspector.hpp"

#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

/// The first edit wins: a person changes one thing per frame.
void keep(std::optional<Edit>& edit, std::optional<Edit> next) {
  if (!edit) edit = std::move(next);
}

std::optional<Edit> activeObject(Ui& ui, InspectorState& state, const InspectorInput& input) {
  const Object* object = find(input.scene, input.document.active());
  if (!object) {
    ImGui::Dummy({0, ui.px(6)});
    dimText("Nothing is selected. Click something in the viewport or in the outliner.");
    return std::nullopt;
  }
  ImGui::PushID(int(object->id));
  std::optional<Edit> edit = inspectObject(ui, input.scene, *object);
  keep(edit, inspectTransform(ui, state.euler, input.scene, *object));
  if (std::holds_alternative<Geometry>(object->content)) {
    keep(edit, inspectShape(ui, input, *object));
    keep(edit, inspectMaterial(ui, input, *object));
  }
  if (std::holds_alternative<Light>(object->content)) keep(edit, inspectLight(ui, input.scene, *object));
  if (std::holds_alternative<steradian::Camera>(object->content))
    keep(edit, inspectCamera(ui, input, *object));
  ImGui::PopID();
  return edit;
}

bool beginTab(Ui& ui, const char* name, const char* help) {
  const bool open = ImGui::BeginTabItem(name);
  ui.mark(std::string("inspector/tab/") + name);
  if (ImGui::IsItemHovered() && !open) tooltip(help);
  if (open) ImGui::BeginChild(name);
  return open;
}

void endTab() {
  ImGui::EndChild();
  ImGui::EndTabItem();
}

}  // namespace

std::optional<Edit> inspector(Ui& ui, InspectorState& state, const InspectorInput& input) {
  std::optional<Edit> edit;
  if (!ImGui::BeginTabBar("inspector")) return edit;
  if (beginTab(ui, "Object", "The active object and its material")) {
    keep(edit, activeObject(ui, state, input));
    endTab();
  }
  if (beginTab(ui, "Render", "How light is simulated")) {
    keep(edit, inspectRender(ui, input.scene));
    inspectStatistics(ui, input);
    endTab();
  }
  if (beginTab(ui, "Display", "How radiance is shown and written to PNG")) {
    keep(edit, inspectDisplay(ui, input));
    endTab();
  }
  ImGui::EndTabBar();
  return edit;
}

}  // namespace steradian::ui
