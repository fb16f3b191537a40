// SPDX-License-Identifier: MIT
// Rows of the outliner and what can be done in them.
#include "editor/ui/outliner.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <unordered_set>

#include "editor/ui/icons.hpp"
#include "editor/ui/style.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

constexpr const char* kDragKind = "objects";

std::string lowered(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/// One pass over the tree; collects at most one edit.
class Tree {
 public:
  Tree(Ui& ui, OutlinerState& state, const Document& document)
      : ui_(ui),
        state_(state),
        document_(document),
        scene_(document.scene()),
        search_(lowered(state.search)) {
    state.tree.follow(document.snapshot());
  }

  std::optional<Edit> draw() {
    drawChildren(Id::none);
    return std::move(edit_);
  }

 private:
  void drawChildren(Id parent) {
    const auto found = state_.tree.children.find(parent);
    if (found == state_.tree.children.end()) return;
    for (const std::size_t index : found->second) {
      const Object& object = scene_.objects[index];
      if (search_.empty()) {
        drawObject(object, state_.tree.visible[index]);
      } else {
        if (lowered(object.name).find(search_) != std::string::npos)
          drawRow(object, true, state_.tree.visible[index]);
        drawChildren(object.id);
      }
    }
  }

  void drawObject(const Object& object, bool shown) {
    const bool leaf = !state_.tree.children.contains(object.id);
    if (!drawRow(object, leaf, shown) || leaf) return;
    drawChildren(object.id);
    ImGui::TreePop();
  }

  /// Leaves that are scrolled out of sight only take their place: a scene may have very many.
  bool outOfSight(const Object& object, bool leaf) const {
    const bool wanted =
        state_.renaming == object.id || (document_.active() == object.id && state_.shownActive != object.id);
    return leaf && !wanted && !ImGui::IsRectVisible({1.0f, ImGui::GetFrameHeight()});
  }

  bool drawRow(const Object& object, bool leaf, bool shown) {
    if (outOfSight(object, leaf)) {
      ImGui::Dummy({0.0f, ImGui::GetFrameHeight()});
      return false;
    }
    ImGui::PushID(int(object.id));
    ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_SpanFullWidth | ImGuiTreeNodeFlags_AllowItemOverlap |
                               ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_DefaultOpen |
                               ImGuiTreeNodeFlags_FramePadding;
    if (leaf) flags |= ImGuiTreeNodeFlags_Leaf | ImGuiTreeNodeFlags_NoTreePushOnOpen;
    const bool selected = document_.selection().contains(object.id);
    if (selected) flags |= ImGuiTreeNodeFlags_Selected;
    const bool active = document_.active() == object.id;
    ImGui::PushStyleColor(ImGuiCol_Header, active ? IM_COL32(104, 78, 46, 255) : IM_COL32(76, 66, 54, 255));
    const bool open = ImGui::TreeNodeEx("##row", flags);
    ImGui::PopStyleColor();
    ui_.mark("outliner/" + object.name);
    handleRow(object);
    if (active && state_.shownActive != object.id) {
      ImGui::SetScrollHereY(0.5f);
      state_.shownActive = object.id;
    }
    drawContent(object, shown);
    ImGui::PopID();
    return open;
  }

  void handleRow(const Object& object) {
    if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) {
      const ImGuiIO& io = ImGui::GetIO();
      state_.shownActive = object.id;
      ui_.ask(Select{object.id, io.KeyCtrl    ? Select::How::toggle
                                : io.KeyShift ? Select::How::extend
                                              : Select::How::only});
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) startRename(object.id);
    contextMenu(object);
    dragAndDrop(object);
  }

  void startRename(Id object) {
    state_.renaming = object;
    state_.renameStarts = true;
  }

  void contextMenu(const Object& object) {
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right) && !document_.selection().contains(object.id))
      ui_.ask(Select{object.id});
    if (!ImGui::BeginPopupContextItem("row menu")) return;
    for (const Command command : {Command::rename, Command::duplicate, Command::toggleVisible,
                                  Command::focusSelection, Command::remove}) {
      const CommandInfo& info = infoOf(command);
      if (ImGui::MenuItem(info.text, chordText(info.chord).c_str())) ui_.ask(command);
      ui_.mark(std::string("row menu/") + info.text);
    }
    if (object.parent != Id::none && ImGui::MenuItem("Move to top level")) reparent(Id::none, object.id);
    if (std::holds_alternative<Camera>(object.content) && ImGui::MenuItem("Look through"))
      ui_.ask(LookThrough{object.id});
    ImGui::EndPopup();
  }

  void dragAndDrop(const Object& object) {
    if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoHoldToOpenOthers)) {
      ImGui::SetDragDropPayload(kDragKind, &object.id, sizeof object.id);
      ImGui::TextUnformatted(object.name.c_str());
      ImGui::EndDragDropSource();
    }
    if (ImGui::BeginDragDropTarget()) {
      if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kDragKind))
        reparent(object.id, *static_cast<const Id*>(payload->Data));
      ImGui::EndDragDropTarget();
    }
  }

  /// The dragged object, or the whole selection when it is part of it.
  void reparent(Id parent, Id dragged) {
    std::vector<Id> moved = document_.selected();
    if (!document_.selection().contains(dragged)) moved = {dragged};
    for (const Id id : moved)
      for (Id up = parent; up != Id::none;) {
        if (up == id) return;  // into itself: nothing happens, as in a file manager
        const Object* above = find(scene_, up);
        up = above ? above->parent : Id::none;
      }
    edit_ = Edit{edits::setParent(scene_, moved, parent), "Reparent"};
  }

  void drawContent(const Object& object, bool shown) {
    const ImVec2 rowMin = ImGui::GetItemRectMin(), rowMax = ImGui::GetItemRectMax();
    ImGui::SameLine(0, 0);
    const float icon = ImGui::GetFontSize() * 0.82f;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 iconCenter{at.x + icon * 0.5f, (rowMin.y + rowMax.y) * 0.5f};
    const ImU32 tint = shown ? iconColor(object) : color::kDim;
    drawKindIcon(*ImGui::GetWindowDrawList(), iconCenter, icon, object.content, tint);
    ImGui::SetCursorScreenPos({at.x + icon + ui_.px(6), rowMin.y});
    drawName(object, shown);
    drawEyeButton(object, shown, (rowMin.y + rowMax.y) * 0.5f);
  }

  static ImU32 iconColor(const Object& object) {
    if (std::holds_alternative<Light>(object.content)) return IM_COL32(240, 208, 120, 255);
    if (std::holds_alternative<Camera>(object.content)) return IM_COL32(150, 190, 230, 255);
    return IM_COL32(176, 182, 190, 255);
  }

  void drawName(const Object& object, bool shown) {
    if (state_.renaming != object.id) {
      ImGui::AlignTextToFramePadding();
      ImGui::PushStyleColor(ImGuiCol_Text, shown ? color::kText : color::kDim);
      ImGui::TextUnformatted(object.name.c_str());
      ImGui::PopStyleColor();
      return;
    }
    if (std::exchange(state_.renameStarts, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ui_.px(26));
    std::string name = object.name;
    if (ImGui::InputText("##rename", &name, ImGuiInputTextFlags_AutoSelectAll))
      edit_ = Edit{edits::rename(scene_, object.id, name), "Rename " + object.name};
    ui_.mark("outliner/rename");
    if (ImGui::IsItemDeactivated()) state_.renaming = Id::none;
  }

  void drawEyeButton(const Object& object, bool shown, float centerY) {
    const float size = ImGui::GetFontSize();
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    ImGui::SameLine();
    ImGui::SetCursorScreenPos({right - size - ui_.px(4), centerY - size * 0.5f});
    if (ImGui::InvisibleButton("eye", {size, size}))
      edit_ = Edit{edits::setVisible(scene_, std::vector{object.id}, !object.visible),
                   (object.visible ? "Hide " : "Show ") + object.name};
    ui_.mark("outliner/" + object.name + "/eye");
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) tooltip(object.visible ? "Hide in viewport and render, with what it holds" : "Show");
    const ImU32 tint = hovered                   ? color::kText
                       : object.visible && shown ? color::kDim
                                                 : IM_COL32(96, 100, 106, 255);
    drawEye(*ImGui::GetWindowDrawList(), {right - size * 0.5f - ui_.px(4), centerY}, size * 0.8f,
            object.visible, tint);
  }

  Ui& ui_;
  OutlinerState& state_;
  const Document& document_;
  const Scene& scene_;
  std::string search_;
  std::optional<Edit> edit_;
};

}  // namespace

void OutlinerTree::follow(const Snapshot& next) {
  if (scene == next) return;
  scene = next;
  children.clear();
  std::unordered_set<Id> there;
  for (const Object& object : scene->objects) there.insert(object.id);
  for (std::size_t i = 0; i < scene->objects.size(); ++i) {
    const Id parent = scene->objects[i].parent;
    children[there.contains(parent) ? parent : Id::none].push_back(i);
  }
  visible = hierarchyVisibility(*scene);
}

std::optional<Edit> outliner(Ui& ui, OutlinerState& state, const Document& document) {
  if (button(ui, "+ Add", "outliner/Add", "Add a shape, light, camera or group (Shift+A)"))
    ui.ask(Command::addMenu);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::InputTextWithHint("##search", "Search", &state.search);
  ui.mark("outliner/Search");
  ImGui::BeginChild("tree");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(4), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(4), ui.px(3)});
  if (document.active() == Id::none) state.shownActive = Id::none;
  std::optional<Edit> edit = Tree(ui, state, document).draw();
  ImGui::PopStyleVar(2);
  if (document.scene().objects.empty()) dimText("The scene is empty. Add something with Shift+A.");
  const bool onFreeSpace = ImGui::IsWindowHovered() && !ImGui::IsAnyItemHovered();
  if (onFreeSpace && ImGui::IsMouseClicked(0)) ui.ask(Select{});
  ImGui::EndChild();
  return edit;
}

}  // namespace steradian::ui
