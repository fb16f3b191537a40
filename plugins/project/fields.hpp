// SPDX-License-Identifier: MIT
// Typed reading of one JSON object: what is read is taken out, so what remains is unknown and can be kept.
#pragma once
#include <span>
#include <steradian/plugin.hpp>
#include <string>

#include "json_text.hpp"

namespace project {

/// What a number must satisfy, and how to say so.
struct Range {
  double low, high;
  bool aboveLow;  // low itself is excluded
  const char* text;
};
inline constexpr Range kAny{-1e308, 1e308, false, "a number"};
inline constexpr Range kPositive{0, 1e308, true, "a number > 0"};
inline constexpr Range kNotNegative{0, 1e308, false, "a number >= 0"};
inline constexpr Range kUnit{0, 1, false, "a number from 0 to 1"};

/// Every function leaves the target as it is when the key is absent, and throws BadInput
/// "/objects/3/sphere/radius: expected a number > 0, got \"big\"" when the value does not fit.
class Fields {
 public:
  Fields(Json& json, std::string path);

  bool has(const char* key) const { return json_.contains(key); }
  void read(const char* key, double& out, const Range& range = kAny);
  void read(const char* key, float& out, const Range& range = kAny);
  void read(const char* key, std::span<double> out, const Range& range = kAny);
  void read(const char* key, std::span<float> out, const Range& range = kAny);
  void readInteger(const char* key, std::int32_t& out, double low, double high);
  void readUnsigned(const char* key, std::uint32_t& out, double low = 0);
  void readFlag(const char* key, std::uint32_t& out);
  void readText(const char* key, std::string& out);
  void readChoice(const char* key, std::uint32_t& out, std::span<const char* const> names);

  /// Runs work(Fields) on the object under `key`, when there is one; removes it when nothing unknown is left.
  template <class Work>
  bool within(const char* key, Work&& work);
  /// Runs work(Fields) on each object of the array under `key`, then removes the array.
  template <class Work>
  void each(const char* key, Work&& work);
  /// Runs work(name, Json&, path) on each member of the object under `key`, then removes it.
  template <class Work>
  void members(const char* key, Work&& work);

  const std::string& path() const { return path_; }
  std::string leftover() const { return json_.empty() ? std::string() : json_.dump(); }
  [[noreturn]] void fail(const char* key, const std::string& expected) const;

 private:
  Json* object(const char* key);
  Json* array(const char* key);
  double take(const char* key, const Range& range);
  void takeWhole(const char* key, double low, double high, double& out);

  Json& json_;
  std::string path_;
};

/// The number at `path`; throws BadInput when it is none or out of range.
double numberFrom(const Json& json, const std::string& path, const Range& range);
[[noreturn]] void failAt(const std::string& path, const std::string& expected, const Json& got);

template <class Work>
bool Fields::within(const char* key, Work&& work) {
  Json* inner = object(key);
  if (!inner) return false;
  work(Fields(*inner, path_ + "/" + key));
  if (inner->empty()) json_.erase(key);
  return true;
}

template <class Work>
void Fields::each(const char* key, Work&& work) {
  Json* list = array(key);
  if (!list) return;
  std::size_t index = 0;
  for (Json& element : *list) work(Fields(element, path_ + "/" + key + "/" + std::to_string(index++)));
  json_.erase(key);
}

template <class Work>
void Fields::members(const char* key, Work&& work) {
  Json* inner = object(key);
  if (!inner) return;
  for (auto it = inner->begin(); it != inner->end(); ++it)
    work(it.key(), *it, path_ + "/" + key + "/" + it.key());
  json_.erase(key);
}

}  // namespace project
