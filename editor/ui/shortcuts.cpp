// SPDX-License-Identifier: MIT
// GLFW's keys are positions on an American keyboard. glfwGetKeyName tells the
// letter of the active layout, so that Ctrl+Z is where Z is printed on AZERTY and QWERTZ too.
#include "editor/ui/shortcuts.hpp"

#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include <cctype>
#include <optional>
#include <string>

namespace steradian::ui {

namespace {

std::optional<int> namedKey(std::string_view name) {
  struct Named {
    std::string_view name;
    int key;
  };
  static constexpr Named kNamed[] = {{"Delete", GLFW_KEY_DELETE}, {"Escape", GLFW_KEY_ESCAPE},
                                     {"Home", GLFW_KEY_HOME},     {"F1", GLFW_KEY_F1},
                                     {"F2", GLFW_KEY_F2},         {"F12", GLFW_KEY_F12}};
  for (const Named& named : kNamed)
    if (named.name == name) return named.key;
  return std::nullopt;
}

/// The letter that `key` types. A layout without Latin letters falls back to the American position.
std::string letterOf(int key) {
  const char* printed = glfwGetKeyName(key, 0);
  const bool latin = printed && printed[0] > 0 && printed[1] == 0;
  const int letter = latin ? printed[0] : key;
  return std::string(1, char(std::toupper(letter)));
}

bool matches(const KeyPress& press, const Chord& chord) {
  if (!chord.key || press.control != chord.control || press.shift != chord.shift || press.alt != chord.alt)
    return false;
  if (const auto key = namedKey(chord.key)) return press.key == *key;
  const bool printable = press.key > GLFW_KEY_SPACE && press.key <= GLFW_KEY_WORLD_2;
  return printable && letterOf(press.key) == chord.key;
}

std::optional<Command> commandOf(const KeyPress& press) {
  for (const CommandInfo& info : commandTable())
    if (matches(press, info.chord)) return info.command;
  if (matches(press, {"Y", true})) return Command::redo;  // the other habit for redo
  return std::nullopt;
}

}  // namespace

void shortcuts(Ui& ui, const std::vector<KeyPress>& presses) {
  if (ImGui::GetIO().WantTextInput) return;
  if (ImGui::GetTopMostPopupModal()) return;  // a dialog answers for itself
  for (const KeyPress& press : presses) {
    const std::optional<Command> command = commandOf(press);
    if (!command) continue;
    // Menus give way to any shortcut; Escape means them alone. All at once: the mouse would open the inner
    // one again.
    const bool menus = ImGui::GetCurrentContext()->OpenPopupStack.Size > 0;
    if (menus) ImGui::ClosePopupToLevel(0, true);
    if (!menus || !matches(press, {"Escape"})) ui.ask(*command);
  }
}

}  // namespace steradian::ui
