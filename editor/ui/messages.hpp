// SPDX-License-Identifier: MIT
// The messages panel: one line per event, newest below; errors stay until they are cleared.
#pragma once
#include <deque>
#include <string>

#include "editor/ui/ui.hpp"

namespace steradian::ui {

class Messages {
 public:
  enum class Kind { note, warning, error };

  void note(std::string text) { add(Kind::note, std::move(text)); }
  void warning(std::string text) { add(Kind::warning, std::move(text)); }
  void error(std::string text) { add(Kind::error, std::move(text)); }
  void add(Kind kind, std::string text);
  int errors() const;

  void draw(Ui& ui);

 private:
  struct Line {
    Kind kind;
    std::string time, text;
    int count = 1;  // the same line again only counts up
  };
  static constexpr std::size_t kMost = 500;

  void drawLine(Ui& ui, const Line& line) const;

  std::deque<Line> lines_;
  bool scrollDown_ = false;
};

}  // namespace steradian::ui
