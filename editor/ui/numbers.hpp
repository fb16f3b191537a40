// SPDX-License-Identifier: MIT
// Figures as people read them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace steradian::ui {

/// snprintf of a short text: at most 127 characters.
template <class... Args>
std::string formatted(const char* format, Args... args) {
  char text[128];
  std::snprintf(text, sizeof text, format, args...);
  return text;
}

std::string percent(double ratio);           // "1.25 %"
std::string duration(double seconds);        // "1 min 5 s"
std::string countText(std::uint64_t count);  // "12,345"
std::string memoryText(std::size_t bytes);   // "80.1 MiB"

}  // namespace steradian::ui
