// SPDX-License-Identifier: MIT
// The outliner: the scene as a tree to select, rename, hide, reparent, duplicate and delete in.
#pragma once
#include <optional>
#include <string>

#include "editor/document.hpp"
#include "editor/ui/ui.hpp"

namespace steradian::ui {

struct OutlinerState {
  std::string search;
  Id renaming = Id::none;
  bool renameStarts = false;
  Id shownActive = Id::none;  // the active object that was last scrolled to
};

std::optional<Edit> outliner(Ui& ui, OutlinerState& state, const Document& document);

}  // namespace steradian::ui
