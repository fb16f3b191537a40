// SPDX-License-Identifier: MIT
// The menu bar and the Add menu.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/document.hpp"
#include "editor/ui/ui.hpp"
#include "renderer/presenter.hpp"

namespace steradian::ui {

struct MenuInput {
  const Document& document;
  const std::vector<std::filesystem::path>& recent;  // newest first
  bool paused = false;
  bool throughCamera = false;
};

/// Things that menus switch and that are neither edits nor commands.
struct ViewOptions {
  bool overlay = true;
  bool messages = true;
  bool outliner = true;
  bool inspector = true;
  int sampleLimit = 4096;  // the viewport rests after so many; 0 = never
};

/// Inside a window with a menu bar.
void menuBar(Ui& ui, const MenuInput& input, ViewOptions& options);

/// The entries of the Add menu; inside any open menu or popup.
void addMenuItems(Ui& ui);

}  // namespace steradian::ui
