// SPDX-License-Identifier: MIT
// The list of messages and how it is drawn.
#include "editor/ui/messages.hpp"

#include <algorithm>
#include <ctime>

#include "editor/ui/style.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

std::string timeOfDay() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[16];
  std::strftime(text, sizeof text, "%H:%M:%S", &local);
  return text;
}

ImU32 colorOf(Messages::Kind kind) {
  if (kind == Messages::Kind::error) return color::kError;
  return kind == Messages::Kind::warning ? color::kWarning : color::kText;
}

}  // namespace

int Messages::errors() const {
  return int(std::ranges::count(lines_, Kind::error, &Line::kind));
}

void Messages::add(Kind kind, std::string text) {
  scrollDown_ = true;
  if (!lines_.empty() && lines_.back().kind == kind && lines_.back().text == text) {
    lines_.back().time = timeOfDay();
    ++lines_.back().count;
    return;
  }
  lines_.push_back({kind, timeOfDay(), std::move(text)});
  if (lines_.size() > kMost) lines_.pop_front();
}

void Messages::drawLine(Ui& ui, const Line& line) const {
  ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
  ImGui::TextUnformatted(line.time.c_str());
  ImGui::PopStyleColor();
  ImGui::SameLine(0, ui.px(10));
  ImGui::PushStyleColor(ImGuiCol_Text, colorOf(line.kind));
  const std::string repeated = line.count > 1 ? "  (" + std::to_string(line.count) + " times)" : "";
  ImGui::TextWrapped("%s%s", line.text.c_str(), repeated.c_str());
  ImGui::PopStyleColor();
  if (ImGui::BeginPopupContextItem("line")) {
    if (ImGui::MenuItem("Copy")) ImGui::SetClipboardText(line.text.c_str());
    ImGui::EndPopup();
  }
}

void Messages::draw(Ui& ui) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Messages");
  ImGui::SameLine(ImGui::GetContentRegionAvail().x - ui.px(46));
  if (button(ui, "Clear", "messages/Clear", "Empty this list")) lines_.clear();
  ImGui::BeginChild("lines");
  if (lines_.empty()) dimText("Nothing to report.");
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    ImGui::PushID(int(i));
    drawLine(ui, lines_[i]);
    ImGui::PopID();
  }
  if (std::exchange(scrollDown_, false)) ImGui::SetScrollHereY(1.0f);
  ImGui::EndChild();
}

}  // namespace steradian::ui
