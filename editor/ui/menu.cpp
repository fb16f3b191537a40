// SPDX-License-Identifier: MIT
// Entries of the menus; every text and key comes from the command table.
#include "editor/ui/menu.hpp"

#include "editor/ui/icons.hpp"
#include "editor/ui/style.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

void item(Ui& ui, const char* menu, Command command, bool enabled = true, bool checked = false,
          const std::string& text = {}) {
  const CommandInfo& info = infoOf(command);
  const std::string shown = text.empty() ? info.text : text;
  if (ImGui::MenuItem(shown.c_str(), chordText(info.chord).c_str(), checked, enabled)) ui.ask(command);
  ui.mark(std::string(menu) + "/" + info.text);
}

bool beginMenu(Ui& ui, const char* name) {
  const bool open = ImGui::BeginMenu(name);
  ui.mark(std::string("menu/") + name);
  return open;
}

void fileMenu(Ui& ui, const MenuInput& input) {
  if (!beginMenu(ui, "File")) return;
  item(ui, "File", Command::newScene);
  item(ui, "File", Command::open);
  if (ImGui::BeginMenu("Open recent", !input.recent.empty())) {
    for (const std::filesystem::path& path : input.recent) {
      if (ImGui::MenuItem(path.filename().c_str())) ui.ask(OpenFile{path});
      if (ImGui::IsItemHovered()) tooltip(path.c_str());
    }
    ImGui::EndMenu();
  }
  item(ui, "File", Command::import);
  ImGui::Separator();
  item(ui, "File", Command::save);
  item(ui, "File", Command::saveAs);
  ImGui::Separator();
  item(ui, "File", Command::exportStill);
  item(ui, "File", Command::screenshot);
  ImGui::Separator();
  item(ui, "File", Command::quit);
  ImGui::EndMenu();
}

void editMenu(Ui& ui, const MenuInput& input) {
  if (!beginMenu(ui, "Edit")) return;
  const auto undo = input.document.undoName(), redo = input.document.redoName();
  const bool selected = !input.document.selection().empty();
  item(ui, "Edit", Command::undo, undo.has_value(), false, undo ? "Undo " + *undo : "Undo");
  item(ui, "Edit", Command::redo, redo.has_value(), false, redo ? "Redo " + *redo : "Redo");
  ImGui::Separator();
  item(ui, "Edit", Command::duplicate, selected);
  item(ui, "Edit", Command::remove, selected);
  item(ui, "Edit", Command::rename, selected);
  item(ui, "Edit", Command::toggleVisible, selected);
  ImGui::Separator();
  item(ui, "Edit", Command::selectAll);
  item(ui, "Edit", Command::selectNone, selected);
  ImGui::EndMenu();
}

void sampleLimitMenu(Ui& ui, ViewOptions& options) {
  const bool open = ImGui::BeginMenu("Rest after");
  ui.mark("View/Rest after");
  if (!open) return;
  for (const int limit : {16, 64, 256, 1024, 4096, 16384, 0}) {
    const std::string text = limit ? std::to_string(limit) + " samples" : "never";
    if (ImGui::MenuItem(text.c_str(), nullptr, options.sampleLimit == limit)) options.sampleLimit = limit;
    ui.mark("Rest after/" + text);
  }
  ImGui::EndMenu();
}

void viewMenu(Ui& ui, const MenuInput& input, ViewOptions& options) {
  if (!beginMenu(ui, "View")) return;
  item(ui, "View", Command::focusSelection, !input.document.selection().empty());
  item(ui, "View", Command::frameAll);
  item(ui, "View", Command::lookThrough, true, input.throughCamera);
  item(ui, "View", Command::viewToCamera);
  ImGui::Separator();
  item(ui, "View", Command::togglePause, true, input.paused);
  sampleLimitMenu(ui, options);
  ImGui::Separator();
  ImGui::MenuItem("Outlines and light marks", nullptr, &options.overlay);
  ImGui::MenuItem("Outliner", nullptr, &options.outliner);
  ImGui::MenuItem("Inspector", nullptr, &options.inspector);
  ImGui::MenuItem("Messages", nullptr, &options.messages);
  ImGui::EndMenu();
}

void addItem(Ui& ui, const char* name, const edits::Content& content) {
  const std::string text = std::string("      ") + name;
  if (ImGui::MenuItem(text.c_str())) ui.ask(AddObject{content});
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const float size = ImGui::GetFontSize() * 0.85f;
  drawKindIcon(*ImGui::GetWindowDrawList(), {min.x + size * 0.9f, (min.y + max.y) * 0.5f}, size, content,
               color::kText);
  ui.mark(std::string("Add/") + name);
}

constexpr float kSunDiameter = 0.0093f;  // radians

/// A blue zenith over a bright haze and a dull ground.
Light clearSky() {
  return {.kind = EnvironmentLight{.horizon = {2.0f, 1.45f, 1.0f}, .ground = {0.8f, 0.55f, 0.3f}},
          .color = {0.45f, 0.65f, 1.0f},
          .intensity = 20.0f};
}

}  // namespace

void addMenuItems(Ui& ui) {
  addItem(ui, "Sphere", Geometry{Sphere{}});
  addItem(ui, "Plane", Geometry{Plane{}});
  addItem(ui, "Box", Geometry{Box{}});
  addItem(ui, "Rectangle", Geometry{Rect{}});
  addItem(ui, "Disk", Geometry{Disk{}});
  addItem(ui, "Cylinder", Geometry{Cylinder{}});
  ImGui::Separator();
  addItem(ui, "Point light", Light{PointLight{}});
  addItem(ui, "Spot light", Light{SpotLight{}});
  addItem(ui, "Directional light", Light{.kind = DirectionalLight{kSunDiameter}, .intensity = 1000.0f});
  addItem(ui, "Sphere light", Light{SphereLight{}});
  addItem(ui, "Rectangle light", Light{RectLight{}});
  addItem(ui, "Disk light", Light{DiskLight{}});
  addItem(ui, "Environment", clearSky());
  ImGui::Separator();
  addItem(ui, "Camera", steradian::Camera{});
  addItem(ui, "Group", Group{});
}

void menuBar(Ui& ui, const MenuInput& input, ViewOptions& options) {
  fileMenu(ui, input);
  editMenu(ui, input);
  if (beginMenu(ui, "Add")) {
    addMenuItems(ui);
    ImGui::EndMenu();
  }
  viewMenu(ui, input, options);
  if (beginMenu(ui, "Help")) {
    item(ui, "Help", Command::showKeys);
    item(ui, "Help", Command::showAbout);
    ImGui::EndMenu();
  }
}

}  // namespace steradian::ui
