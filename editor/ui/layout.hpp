// SPDX-License-Identifier: MIT
// Where the panels are: fixed places, sizes that a person drags.
#pragma once
#include "editor/ui/menu.hpp"
#include "editor/ui/overlay.hpp"

namespace steradian::ui {

struct Layout {
  ViewRect outliner, inspector, messages, viewport, status;
};

class PanelLayout {
 public:
  /// The window below a menu bar of `menuHeight`; hidden panels get no room.
  Layout compute(const Ui& ui, const ViewOptions& options, float menuHeight) const;
  /// The borders between panels, as handles.
  void handles(Ui& ui, const ViewOptions& options, const Layout& layout);

 private:
  void handle(Ui& ui, const char* name, ViewRect rect, bool vertical, float sign, float& size, float minimum);

  float left_ = 224.0f, right_ = 322.0f, bottom_ = 104.0f;  // design pixels
};

/// A panel without decoration at a fixed place; always call ImGui::End().
void beginPanel(const char* name, const ViewRect& rect, bool seeThrough = false);

}  // namespace steradian::ui
