// SPDX-License-Identifier: MIT
// The command table.
#include "editor/ui/commands.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace steradian::ui {

namespace {

constexpr std::array kCommands = {
    CommandInfo{Command::newScene, "New", "An empty room with one light", {"N", true}},
    CommandInfo{Command::open, "Open...", "A project or anything an importer plugin reads", {"O", true}},
    CommandInfo{
        Command::import, "Import...", "Add a model to this scene, or an HDR or EXR as its sky", {"I", true}},
    CommandInfo{Command::save, "Save", "Replace the file as a whole, or not at all", {"S", true}},
    CommandInfo{Command::saveAs, "Save as...", "Save under another name", {"S", true, true}},
    CommandInfo{Command::exportStill, "Export still...", "Render an EXR or PNG file", {"E", true}},
    CommandInfo{Command::screenshot, "Save screenshot", "The window as a PNG in the current folder", {"F12"}},
    CommandInfo{Command::quit, "Quit", "Close the editor", {"Q", true}},
    CommandInfo{Command::undo, "Undo", "Take back the last step", {"Z", true}},
    CommandInfo{Command::redo, "Redo", "Bring back what was undone", {"Z", true, true}},
    CommandInfo{Command::duplicate, "Duplicate", "Copy the selected objects", {"D", false, true}},
    CommandInfo{Command::remove, "Delete", "Remove the selected objects and what they hold", {"Delete"}},
    CommandInfo{Command::rename, "Rename", "Rename the active object", {"F2"}},
    CommandInfo{Command::selectAll, "Select all", "Every object", {"A", true}},
    CommandInfo{Command::selectNone, "Select none", "Clear the selection", {"Escape"}},
    CommandInfo{Command::toggleVisible, "Show or hide", "Visibility of the selected objects", {"H"}},
    CommandInfo{Command::addMenu, "Add...", "A shape, light, camera or group", {"A", false, true}},
    CommandInfo{Command::focusSelection, "Focus selection", "Bring the selected objects into view", {"F"}},
    CommandInfo{Command::frameAll, "Frame all", "Bring the whole scene into view", {"Home"}},
    CommandInfo{Command::lookThrough, "Look through camera", "Switch between camera and free view", {"C"}},
    CommandInfo{Command::viewToCamera,
                "Move camera to view",
                "Put the camera where you look from",
                {"C", true, true}},
    CommandInfo{Command::togglePause, "Pause rendering", "Stop or resume adding samples", {"P"}},
    CommandInfo{Command::showKeys, "Keys and mouse", "Every key and mouse action", {"F1"}},
    CommandInfo{Command::showAbout, "About Steradian", "Version and system information", {}},
};

}  // namespace

std::span<const CommandInfo> commandTable() {
  return kCommands;
}

const CommandInfo& infoOf(Command command) {
  const auto found = std::ranges::find(kCommands, command, &CommandInfo::command);
  assert(found != kCommands.end());
  return *found;
}

std::string chordText(const Chord& chord) {
  if (!chord.key) return {};
  std::string text;
  if (chord.control) text += "Ctrl+";
  if (chord.shift) text += "Shift+";
  if (chord.alt) text += "Alt+";
  return text + chord.key;
}

}  // namespace steradian::ui
