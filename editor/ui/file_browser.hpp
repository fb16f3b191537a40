// SPDX-License-Identifier: MIT
// Choosing a file inside the window: no desktop service needs to be there for Open to work.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/ui/ui.hpp"

namespace steradian::ui {

class FileBrowser {
 public:
  struct Purpose {
    std::string title;   // "Open"
    std::string action;  // on the button
    bool saving = false;
    std::vector<std::string> extensions;  // ".srad" ...; the first is added to a name without one
  };

  /// Shows the dialog from the next draw() on. `start`: a folder, or a file to suggest.
  void open(Purpose purpose, const std::filesystem::path& start);

  /// The chosen path, once; when saving, an existing file was confirmed.
  std::optional<std::filesystem::path> draw(Ui& ui);

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    std::string size, modified;
  };

  void go(const std::filesystem::path& folder);
  void list();
  bool matches(const std::filesystem::path& file) const;
  std::filesystem::path typedPath() const;
  void drawPlaces(Ui& ui);
  void drawPath(Ui& ui);
  bool drawEntries(Ui& ui, float height);
  bool drawRow(Ui& ui, const Entry& entry);
  void drawNewFolder(Ui& ui);
  std::optional<std::filesystem::path> drawButtons(Ui& ui, bool accepted);
  std::optional<std::filesystem::path> accept();

  Purpose purpose_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string name_, newFolder_, problem_, pathText_;
  bool opening_ = false, allFiles_ = false, hidden_ = false, makingFolder_ = false;
  bool askOverwrite_ = false;
};

}  // namespace steradian::ui
