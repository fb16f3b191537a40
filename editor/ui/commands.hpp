// SPDX-License-Identifier: MIT
// What a person can ask for: one table gives menus their texts, keys and tooltips.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "editor/edits.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian::ui {

enum class Command {
  newScene,
  open,
  import,
  save,
  saveAs,
  exportStill,
  screenshot,
  quit,
  undo,
  redo,
  duplicate,
  remove,
  rename,
  selectAll,
  selectNone,
  toggleVisible,
  addMenu,
  focusSelection,
  frameAll,
  lookThrough,
  viewToCamera,
  togglePause,
  showKeys,
  showAbout,
};

/// A chord: `key` is the letter on the keyboard in upper case, or a name from shortcuts.cpp ("Delete").
struct Chord {
  const char* key = nullptr;  // null = none
  bool control = false, shift = false, alt = false;
};

struct CommandInfo {
  Command command;
  const char* text;
  const char* help;
  Chord chord;
};

std::span<const CommandInfo> commandTable();
const CommandInfo& infoOf(Command command);
std::string chordText(const Chord& chord);  // "Ctrl+Shift+Z", empty for none

// Requests: what panels collect during a frame; the application carries them out between frames.
struct Run {
  Command command;
};
struct OpenFile {
  std::filesystem::path path;
};
struct ImportFiles {
  std::vector<std::filesystem::path> paths;  // into the open scene
};
struct AddObject {
  edits::Content content;  // at a size for a place one metre away; scaled to the view
};
struct Select {
  enum class How { only, toggle, extend };
  Id object = Id::none;
  How how = How::only;
};
struct LookThrough {
  Id camera = Id::none;  // none = the free view
};
struct ChooseSky {
  Id light = Id::none;  // the environment light that gets an image
};
struct CancelLoading {};
using Request =
    std::variant<Run, OpenFile, ImportFiles, AddObject, Select, LookThrough, ChooseSky, CancelLoading>;

}  // namespace steradian::ui
