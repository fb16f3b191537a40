// SPDX-License-Identifier: MIT
// The label file behind STERADIAN_UI_LABELS.
#include "editor/ui/labels.hpp"

#include <cstdlib>
#include <fstream>
#include <system_error>

namespace steradian::ui {

Labels Labels::fromEnvironment() {
  const char* file = std::getenv("STERADIAN_UI_LABELS");
  return Labels(file ? file : "");
}

void Labels::add(std::string_view label, ImVec2 min, ImVec2 max) {
  if (wanted()) current_[std::string(label)] = {min.x, min.y, max.x - min.x, max.y - min.y};
}

void Labels::end() {
  if (!wanted() || current_ == written_) return;
  const std::filesystem::path temporary = file_.string() + ".new";
  {
    std::ofstream out(temporary);
    for (const auto& [label, r] : current_) {
      out << "{\"label\":\"";
      for (const char c : label) out << (c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c});
      out << "\",\"x\":" << r.x << ",\"y\":" << r.y << ",\"width\":" << r.width << ",\"height\":" << r.height
          << "}\n";
    }
  }
  std::error_code failed;
  std::filesystem::rename(temporary, file_, failed);
  if (!failed) written_ = current_;
}

}  // namespace steradian::ui
