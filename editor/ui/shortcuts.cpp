// SPDX-License-Identifier: MIT
// ImGui 1.86 passes raw GLFW keys on, which are positions on an American keyboard. glfwGetKeyName tells the
// letter of the active layout, so that Ctrl+Z is where Z is printed on AZERTY and QWERTZ too.
#include "editor/ui/shortcuts.hpp"

#include <GLFW/glfw3.h>

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

bool keyPressed(std::string_view name) {
  if (const auto key = namedKey(name)) return ImGui::IsKeyPressed(*key, false);
  for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key)
    if (ImGui::IsKeyPressed(key, false) && letterOf(key) == name) return true;
  // On some layouts a letter lies where America has punctuation (M on AZERTY).
  for (const int key : {GLFW_KEY_SEMICOLON, GLFW_KEY_COMMA, GLFW_KEY_APOSTROPHE})
    if (ImGui::IsKeyPressed(key, false) && letterOf(key) == name) return true;
  return false;
}

bool pressed(const Chord& chord) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!chord.key || io.KeyCtrl != chord.control || io.KeyShift != chord.shift || io.KeyAlt != chord.alt)
    return false;
  return keyPressed(chord.key);
}

}  // namespace

void shortcuts(Ui& ui) {
  if (ImGui::GetIO().WantTextInput) return;
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
  for (const CommandInfo& info : commandTable())
    if (pressed(info.chord)) ui.ask(info.command);
  if (pressed({"Y", true})) ui.ask(Command::redo);  // the other habit for redo
}

}  // namespace steradian::ui
