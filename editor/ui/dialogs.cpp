// SPDX-License-Identifier: MIT
// The small dialogs' contents.
#include "editor/ui/dialogs.hpp"

#include "editor/ui/style.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize;

void center() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.45f}, ImGuiCond_Appearing, {0.5f, 0.5f});
}

void keyRow(const std::string& keys, const char* text) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextColored(ImColor(color::kAccent), "%s", keys.c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text);
}

}  // namespace

void UnsavedDialog::ask(std::string title, std::function<void()> next) {
  title_ = std::move(title);
  next_ = std::move(next);
  opening_ = true;
}

std::optional<UnsavedDialog::Answer> UnsavedDialog::draw(Ui& ui) {
  if (std::exchange(opening_, false)) ImGui::OpenPopup("Unsaved changes");
  center();
  if (!ImGui::BeginPopupModal("Unsaved changes", nullptr, kFixed)) return std::nullopt;
  ImGui::Text("%s has changes that are not saved.", title_.c_str());
  ImGui::Dummy({0, ui.px(8)});
  std::optional<Answer> answer;
  if (mainButton(ui, "Save", "dialog/Save", ui.px(110))) answer = Answer::save;
  ImGui::SameLine();
  if (button(ui, "Discard", "dialog/Discard", "Lose the changes", ui.px(110))) answer = Answer::discard;
  ImGui::SameLine();
  const bool cancel = button(ui, "Cancel", "dialog/Cancel", "Go on editing", ui.px(110)) ||
                      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (cancel) drop();
  if (cancel || answer) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return answer;
}

void InfoDialogs::drawKeys(Ui& ui) {
  if (std::exchange(keys_, false)) ImGui::OpenPopup("Keys and mouse");
  center();
  bool shown = true;
  if (!ImGui::BeginPopupModal("Keys and mouse", &shown, kFixed)) return;
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    keyRow("Middle drag, Alt+left drag", "Orbit");
    keyRow("Shift + the same", "Pan");
    keyRow("Ctrl + the same, wheel", "Zoom");
    keyRow("Click, Ctrl+click", "Select, add to the selection");
    for (const CommandInfo& info : commandTable())
      if (info.chord.key) keyRow(chordText(info.chord), info.text);
    ImGui::EndTable();
  }
  if (button(ui, "Close", "dialog/Close", nullptr, ui.px(110)) ||
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
    ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void InfoDialogs::drawAbout(Ui& ui, const std::string& systemInformation) {
  if (std::exchange(about_, false)) ImGui::OpenPopup("About Steradian");
  center();
  bool shown = true;
  if (!ImGui::BeginPopupModal("About Steradian", &shown, kFixed)) return;
  ImGui::TextUnformatted("Steradian edits scenes with a live, physically based, ray-traced viewport.");
  dimText("MIT License.");
  ImGui::Dummy({0, ui.px(6)});
  ImGui::TextUnformatted(systemInformation.c_str());
  ImGui::Dummy({0, ui.px(6)});
  if (button(ui, "Copy", "about/Copy", "System information to the clipboard", ui.px(110)))
    ImGui::SetClipboardText(systemInformation.c_str());
  ImGui::SameLine();
  if (button(ui, "Close", "dialog/Close", nullptr, ui.px(110)) ||
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
    ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void InfoDialogs::draw(Ui& ui, const std::string& systemInformation) {
  drawKeys(ui);
  drawAbout(ui, systemInformation);
}

}  // namespace steradian::ui
