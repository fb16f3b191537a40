// SPDX-License-Identifier: MIT
// Where each widget is on the screen, by name: lets a test drive the real window without fixed coordinates.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include <imgui.h>

namespace steradian::ui {

/// Collects label -> rectangle during a frame and writes the list, one JSON object per line, when it changes.
class Labels {
 public:
  /// `file` empty = collect nothing. The file is replaced as a whole, so a reader never sees half of it.
  explicit Labels(std::filesystem::path file) : file_(std::move(file)) {}
  static Labels fromEnvironment();  // STERADIAN_UI_LABELS=FILE

  bool wanted() const { return !file_.empty(); }
  void begin() { current_.clear(); }
  void add(std::string_view label, ImVec2 min, ImVec2 max);
  void end();

 private:
  struct Rectangle {
    float x, y, width, height;  // window units from the top left
    bool operator==(const Rectangle&) const = default;
  };

  std::filesystem::path file_;
  std::map<std::string, Rectangle, std::less<>> current_, written_;
};

}  // namespace steradian::ui
