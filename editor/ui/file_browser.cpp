// SPDX-License-Identifier: MIT
// The file dialog: places on the left, the folder's entries, the name below.
#include "editor/ui/file_browser.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <ctime>

#include "editor/ui/style.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace fs = std::filesystem;

namespace {

std::string lowered(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

std::string sizeText(std::uintmax_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " B";
  if (bytes < 1000000) return std::to_string(bytes / 1000) + " kB";
  return std::to_string(bytes / 1000000) + " MB";
}

std::string dateText(fs::file_time_type time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(
      std::chrono::file_clock::to_sys(std::chrono::time_point_cast<std::chrono::seconds>(time)));
  std::tm local{};
  localtime_r(&seconds, &local);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &local);
  return text;
}

}  // namespace

void FileBrowser::open(Purpose purpose, const fs::path& start) {
  std::error_code failed;
  purpose_ = std::move(purpose);
  opening_ = true;
  askOverwrite_ = makingFolder_ = false;
  allFiles_ = false;
  name_.clear();
  const fs::path whole = fs::absolute(start.empty() ? fs::current_path(failed) : start, failed);
  if (fs::is_directory(whole, failed)) return go(whole);
  name_ = whole.filename();
  go(fs::is_directory(whole.parent_path(), failed) ? whole.parent_path() : fs::current_path(failed));
}

bool FileBrowser::matches(const fs::path& file) const {
  if (allFiles_ || purpose_.extensions.empty()) return true;
  const std::string extension = lowered(file.extension());
  return std::ranges::any_of(purpose_.extensions,
                             [&](const std::string& e) { return lowered(e) == extension; });
}

void FileBrowser::go(const fs::path& folder) {
  folder_ = folder.lexically_normal();
  pathText_ = folder_;
  problem_.clear();
  list();
}

void FileBrowser::list() {
  entries_.clear();
  std::error_code failed;
  fs::directory_iterator at(folder_, failed);
  if (failed) problem_ = folder_.string() + " cannot be read: " + failed.message() + ".";
  for (; !failed && at != fs::directory_iterator(); at.increment(failed)) {
    std::error_code ignored;
    const fs::path path = at->path();
    if (!hidden_ && path.filename().string().starts_with(".")) continue;
    Entry entry{path.filename(), at->is_directory(ignored), {}, {}};
    if (!entry.folder && !matches(path)) continue;
    const std::uintmax_t size = entry.folder ? 0 : fs::file_size(path, ignored);
    if (!entry.folder && !ignored) entry.size = sizeText(size);
    const auto time = fs::last_write_time(path, ignored);
    if (!ignored) entry.modified = dateText(time);
    entries_.push_back(std::move(entry));
  }
  std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lowered(a.name) < lowered(b.name);
  });
}

fs::path FileBrowser::typedPath() const {
  fs::path path = name_.empty() || name_[0] != '~' || !std::getenv("HOME")
                      ? fs::path(name_)
                      : fs::path(std::getenv("HOME") + name_.substr(1));
  if (path.is_relative()) path = folder_ / path;
  if (purpose_.saving && !path.has_extension() && !purpose_.extensions.empty())
    path += purpose_.extensions.front();
  return path.lexically_normal();
}

void FileBrowser::drawPlaces(Ui& ui) {
  ImGui::BeginChild("places", {ui.px(110), 0});
  std::error_code failed;
  if (const char* home = std::getenv("HOME"); home && ImGui::Selectable("Home")) go(home);
  if (ImGui::Selectable("Working folder")) go(fs::current_path(failed));
  if (ImGui::Selectable("Computer")) go("/");
  ImGui::Dummy({0, ui.px(8)});
  if (ImGui::Checkbox("All files", &allFiles_)) list();
  if (ImGui::Checkbox("Hidden", &hidden_)) list();
  ImGui::EndChild();
}

void FileBrowser::drawPath(Ui& ui) {
  if (button(ui, "Up", "browser/Up", "The folder above")) go(folder_.parent_path());
  ImGui::SameLine();
  if (button(ui, "New folder", "browser/New folder")) makingFolder_ = !makingFolder_;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (ImGui::InputText("##path", &pathText_, ImGuiInputTextFlags_EnterReturnsTrue)) go(pathText_);
  ui.mark("browser/path");
  if (makingFolder_) drawNewFolder(ui);
}

void FileBrowser::drawNewFolder(Ui& ui) {
  ImGui::SetNextItemWidth(ui.px(220));
  const bool entered = ImGui::InputTextWithHint("##new", "Name of the new folder", &newFolder_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if (!button(ui, "Create", "browser/Create") && !entered) return;
  std::error_code failed;
  const fs::path made = folder_ / newFolder_;
  fs::create_directory(made, failed);
  makingFolder_ = false;
  newFolder_.clear();
  if (failed)
    problem_ = made.string() + " cannot be made: " + failed.message() + ".";
  else
    go(made);
}

bool FileBrowser::drawRow(Ui& ui, const Entry& entry) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string text = entry.folder ? entry.name + "/" : entry.name;
  const bool clicked =
      ImGui::Selectable(text.c_str(), !entry.folder && entry.name == name_,
                        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick |
                            ImGuiSelectableFlags_DontClosePopups);
  ui.mark("browser/" + entry.name);
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", entry.size.c_str());
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", entry.modified.c_str());
  if (clicked && !entry.folder) name_ = entry.name;
  return clicked && ImGui::IsMouseDoubleClicked(0);
}

bool FileBrowser::drawEntries(Ui& ui, float height) {
  bool accepted = false;
  std::optional<std::string> entered;
  constexpr ImGuiTableFlags kFlags =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("entries", 3, kFlags, {0, height})) return false;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 6.0f);
  ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthStretch, 1.2f);
  ImGui::TableSetupColumn("modified", ImGuiTableColumnFlags_WidthStretch, 2.2f);
  for (const Entry& entry : entries_) {
    if (!drawRow(ui, entry)) continue;
    if (entry.folder)
      entered = entry.name;
    else
      accepted = true;
  }
  ImGui::EndTable();
  if (entered) go(folder_ / *entered);
  return accepted;
}

std::optional<fs::path> FileBrowser::accept() {
  if (name_.empty()) return std::nullopt;
  std::error_code failed;
  const fs::path path = typedPath();
  if (fs::is_directory(path, failed)) {
    name_.clear();
    go(path);
    return std::nullopt;
  }
  const bool exists = fs::exists(path, failed);
  if (!purpose_.saving && !exists) {
    problem_ = path.string() + " does not exist.";
    return std::nullopt;
  }
  if (purpose_.saving && exists && !askOverwrite_) {
    askOverwrite_ = true;
    return std::nullopt;
  }
  ImGui::CloseCurrentPopup();
  return path;
}

std::optional<fs::path> FileBrowser::drawButtons(Ui& ui, bool accepted) {
  const std::string before = name_;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-ui.px(210));
  accepted |= ImGui::InputTextWithHint("##name", purpose_.saving ? "File name" : "File name or path", &name_,
                                       ImGuiInputTextFlags_EnterReturnsTrue);
  ui.mark("browser/name");
  if (name_ != before) askOverwrite_ = false;
  ImGui::SameLine();
  const char* action = askOverwrite_ ? "Replace" : purpose_.action.c_str();
  accepted |= mainButton(ui, action, "browser/accept", ui.px(100));
  ImGui::SameLine();
  if (button(ui, "Cancel", "browser/Cancel", nullptr, -FLT_MIN)) ImGui::CloseCurrentPopup();
  return accepted ? accept() : std::nullopt;
}

std::optional<fs::path> FileBrowser::draw(Ui& ui) {
  const std::string id = purpose_.title + "###file browser";
  if (std::exchange(opening_, false)) ImGui::OpenPopup("###file browser");
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.5f}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(ui.px(760), screen.x * 0.9f), std::min(ui.px(500), screen.y * 0.85f)},
                           ImGuiCond_Appearing);
  bool shown = true;
  if (!ImGui::BeginPopupModal(id.c_str(), &shown)) return std::nullopt;
  drawPath(ui);
  const float below = ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing() + ui.px(6);
  ImGui::BeginChild("middle", {0, -below});
  drawPlaces(ui);
  ImGui::SameLine();
  const bool accepted = drawEntries(ui, 0.0f);
  ImGui::EndChild();
  const std::string line =
      askOverwrite_ ? typedPath().filename().string() + " exists. Replace it?" : problem_;
  ImGui::TextColored(ImColor(askOverwrite_ ? color::kWarning : color::kError), "%s", line.c_str());
  const std::optional<fs::path> chosen = drawButtons(ui, accepted);
  if (!chosen && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return chosen;
}

}  // namespace steradian::ui
