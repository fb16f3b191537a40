// SPDX-License-Identifier: MIT
// Values under extras.steradian, each within its range.
#pragma once
#include <string>

#include "document.hpp"

namespace gltf {

[[noreturn]] inline void failField(const std::string& key, const std::string& expected) {
  throw sdk::BadInput("extras.steradian." + key + ": expected " + expected);
}

inline double numberIn(const Json& value, const std::string& key, double low, double high) {
  if (!value.is_number() || !(value >= low) || !(value <= high)) failField(key, "a number within its range");
  return value.get<double>();
}

/// Leaves `out` as it is without the key. Throws BadInput.
template <class Number>
void readField(const Json& json, const char* key, Number& out, double low, double high) {
  if (json.contains(key)) out = Number(numberIn(json[key], key, low, high));
}

}  // namespace gltf
