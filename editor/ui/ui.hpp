// SPDX-License-Identifier: MIT
// What every panel gets: the scale, the label book, and a place for requests. Panels never change the scene.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <imgui.h>

#include "editor/ui/commands.hpp"
#include "editor/ui/labels.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian::ui {

/// A changed scene. It is previewed while a widget is held and becomes one undo step when it is let go.
struct Edit {
  Scene scene;
  std::string name;  // of the undo step: "Change roughness of Gold"
};

struct Ui {
  float scale = 1.0f;  // window units per design pixel
  Labels& labels;
  std::vector<Request>& requests;

  float px(float designPixels) const { return designPixels * scale; }
  void ask(Request request);
  void ask(Command command);
  /// Names the last ImGui item for tests.
  void mark(std::string_view label) {
    if (labels.wanted()) labels.add(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  }
};

}  // namespace steradian::ui
