// SPDX-License-Identifier: MIT
// JSON text in and out: parsed with limits and places, written one object per line.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace project {

using Json = nlohmann::json;  // keys sorted: unknown ones have a stable order too
using OrderedJson = nlohmann::ordered_json;

inline constexpr int kDeepest = 64;
inline constexpr std::uint64_t kLargest = 256ull << 20;  // bytes

/// Of duplicate keys the last counts; a byte order mark is skipped. Throws BadInput "line 3, column 7: ...".
Json parseJson(std::string_view text, int deepest = kDeepest);

/// Defaults of layout: an array of objects has one per line, and so has an object that holds such an array.
std::string jsonText(const OrderedJson& json);

}  // namespace project
