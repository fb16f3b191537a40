// SPDX-License-Identifier: MIT
// Small dialogs: the question before losing work, the keys, about.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "editor/ui/ui.hpp"

namespace steradian::ui {

/// "Save changes before ...?" Save, Discard or Cancel; what comes next waits for the answer.
class UnsavedDialog {
 public:
  enum class Answer { save, discard };
  void ask(std::string title, std::function<void()> next);
  bool waiting() const { return bool(next_); }
  std::optional<Answer> draw(Ui& ui);
  /// Hands over what was to be done; empty afterwards.
  std::function<void()> takeNext() { return std::exchange(next_, nullptr); }
  void drop() { next_ = nullptr; }

 private:
  std::string title_;
  std::function<void()> next_;
  bool opening_ = false;
};

/// A window with text that a person closes, for F1 and About.
class InfoDialogs {
 public:
  void showKeys() { keys_ = true; }
  void showAbout() { about_ = true; }
  void draw(Ui& ui, const std::string& systemInformation);

 private:
  void drawKeys(Ui& ui);
  void drawAbout(Ui& ui, const std::string& systemInformation);

  bool keys_ = false, about_ = false;
};

}  // namespace steradian::ui
