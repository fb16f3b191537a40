// SPDX-License-Identifier: MIT
// Typed reading of one JSON object: what is read is taken out, so what remains is unknown and can be kept.
#include "fields.hpp"

#include <cmath>

namespace project {

void failAt(const std::string& path, const std::string& expected, const Json& got) {
  std::string text = got.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > 40) text = text.substr(0, 40) + "...";
  throw steradian::sdk::BadInput((path.empty() ? "/" : path) + ": expected " + expected + ", got " + text);
}

double numberFrom(const Json& json, const std::string& path, const Range& range) {
  if (!json.is_number()) failAt(path, range.text, json);
  const double value = json.get<double>();
  if (!(range.aboveLow ? value > range.low : value >= range.low) || !(value <= range.high))
    failAt(path, range.text, json);
  return value;
}

Fields::Fields(Json& json, std::string path) : json_(json), path_(std::move(path)) {
  if (!json_.is_object()) failAt(path_, "an object {...}", json_);
}

void Fields::fail(const char* key, const std::string& expected) const {
  const auto found = json_.find(key);
  failAt(path_ + "/" + key, expected, found == json_.end() ? Json() : *found);
}

double Fields::take(const char* key, const Range& range) {
  const double value = numberFrom(json_.at(key), path_ + "/" + key, range);
  json_.erase(key);
  return value;
}

void Fields::read(const char* key, double& out, const Range& range) {
  if (has(key)) out = take(key, range);
}

void Fields::read(const char* key, float& out, const Range& range) {
  if (!has(key)) return;
  const float value = float(json_.at(key).is_number() ? json_.at(key).get<double>() : 0.0);
  if (!std::isfinite(value)) fail(key, "a number that fits 32 bits");
  out = float(take(key, range));
}

void Fields::read(const char* key, std::span<double> out, const Range& range) {
  Json* list = array(key);
  if (!list) return;
  if (list->size() != out.size()) fail(key, "an array of " + std::to_string(out.size()) + " numbers");
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = numberFrom((*list)[i], path_ + "/" + key + "/" + std::to_string(i), range);
  json_.erase(key);
}

void Fields::read(const char* key, std::span<float> out, const Range& range) {
  if (!has(key)) return;
  double values[6] = {};
  const std::span<double> wide(values, out.size());
  read(key, wide, range);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = float(values[i]);
    if (!std::isfinite(out[i])) failAt(path_ + "/" + key, "numbers that fit 32 bits", values[i]);
  }
}

void Fields::takeWhole(const char* key, double low, double high, double& out) {
  const std::string text =
      "a whole number from " + Json(std::int64_t(low)).dump() + " to " + Json(std::int64_t(high)).dump();
  const Range range{low, high, false, text.c_str()};
  const double value = numberFrom(json_.at(key), path_ + "/" + key, range);
  if (value != std::floor(value)) fail(key, text);
  out = value;
  json_.erase(key);
}

void Fields::readInteger(const char* key, std::int32_t& out, double low, double high) {
  double value = out;
  if (has(key)) takeWhole(key, low, high, value);
  out = std::int32_t(value);
}

void Fields::readUnsigned(const char* key, std::uint32_t& out, double low) {
  double value = out;
  if (has(key)) takeWhole(key, low, 4294967295.0, value);
  out = std::uint32_t(value);
}

void Fields::readFlag(const char* key, std::uint32_t& out) {
  if (!has(key)) return;
  if (!json_.at(key).is_boolean()) fail(key, "true or false");
  out = json_.at(key).get<bool>();
  json_.erase(key);
}

void Fields::readText(const char* key, std::string& out) {
  if (!has(key)) return;
  if (!json_.at(key).is_string()) fail(key, "a text in quotes");
  out = json_.at(key).get<std::string>();
  json_.erase(key);
}

void Fields::readChoice(const char* key, std::uint32_t& out, std::span<const char* const> names) {
  if (!has(key)) return;
  std::string text;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    text += (i ? ", \"" : "\"") + std::string(names[i]) + "\"";
    if (json_.at(key) != names[i]) continue;
    out = i;
    json_.erase(key);
    return;
  }
  fail(key, "one of " + text);
}

Json* Fields::object(const char* key) {
  const auto found = json_.find(key);
  if (found == json_.end()) return nullptr;
  if (!found->is_object()) fail(key, "an object {...}");
  return &*found;
}

Json* Fields::array(const char* key) {
  const auto found = json_.find(key);
  if (found == json_.end()) return nullptr;
  if (!found->is_array()) fail(key, "an array [...]");
  return &*found;
}

}  // namespace project
