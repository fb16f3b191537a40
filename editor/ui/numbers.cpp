// SPDX-License-Identifier: MIT
// Rounding for people.
#include "editor/ui/numbers.hpp"

#include <cmath>

namespace steradian::ui {

std::string percent(double ratio) {
  const double value = 100.0 * ratio;
  return formatted(value < 1.0 ? "%.2f %%" : value < 10.0 ? "%.1f %%" : "%.0f %%", value);
}

std::string duration(double seconds) {
  if (!(seconds >= 0.0) || seconds > 1e7) return "unknown";
  const long whole = std::lround(seconds);
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

std::string memoryText(std::size_t bytes) {
  if (bytes < std::size_t(1) << 20) return formatted("%.1f KiB", double(bytes) / 1024);
  return formatted(bytes < std::size_t(1) << 30 ? "%.1f MiB" : "%.0f MiB", double(bytes) / (1 << 20));
}

std::string countText(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (int at = int(digits.size()) - 3; at > 0; at -= 3) digits.insert(std::size_t(at), 1, ',');
  return digits;
}

}  // namespace steradian::ui
