// SPDX-License-Identifier: MIT
// The outliner: the scene as a tree to select, rename, hide, reparent, duplicate and delete in.
#pragma once
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "editor/document.hpp"
#include "editor/ui/ui.hpp"

namespace steradian::ui {

/// A scene in the order of its tree: made anew when the scene has changed, not for every frame.
struct OutlinerTree {
  Snapshot scene;
  std::unordered_map<Id, std::vector<std::size_t>> children;  // indices of objects; under none the roots
  std::vector<bool> visible;                                  // with all parents

  void follow(const Snapshot& next);
};

struct OutlinerState {
  OutlinerTree tree;
  std::string search;
  Id renaming = Id::none;
  bool renameStarts = false;
  Id shownActive = Id::none;  // the active object that was last scrolled to
};

std::optional<Edit> outliner(Ui& ui, OutlinerState& state, const Document& document);

}  // namespace steradian::ui
