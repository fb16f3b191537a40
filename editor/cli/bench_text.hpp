// SPDX-License-Identifier: MIT
// What the reports of the benches are written with.
#pragma once
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace steradian::bench {

using Json = nlohmann::ordered_json;

/// printf with a line end; at most 511 characters.
template <class... Values>
std::string line(const char* format, Values... values) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return std::string(buffer) + "\n";
}

inline Json jsonOf(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace steradian::bench
