// SPDX-License-Identifier: MIT
// The rules of glTF 2.0 for single values: type, range, and that every index counts into its list.
#include "schema.hpp"

#include <cmath>

#include "schema_rules.hpp"

namespace gltf {

namespace {

/// "accessors[3].byteOffset" -> "accessors[3]" for the pattern "accessors[]"; empty when it does not begin
/// so.
std::string elementOf(const std::string& place, std::string_view pattern) {
  std::size_t p = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (p >= place.size() || place[p] != pattern[i]) return {};
    ++p;
    if (pattern[i] == '[')
      while (p < place.size() && place[p] != ']') ++p;
  }
  return place.substr(0, p);
}

std::string shortened(const Json& got) {
  std::string text = got.dump();
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

/// `words` are separated by spaces.
bool isAmong(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (end > 0 && words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// Where a value stands; becomes text only when something is wrong there.
struct Place {
  const Place* outer = nullptr;
  std::string_view key = {};  // empty: the element at `index`
  std::size_t index = 0;

  std::string text() const {
    const std::string before = outer ? outer->text() : std::string();
    if (outer && key.empty()) return at(before, index);
    return before.empty() ? std::string(key) : before + "." + std::string(key);
  }
};

class Checker {
 public:
  explicit Checker(Json& json) : json_(json) {}

  Unsound run() {
    const Place root;
    for (const Rule& rule : kRules) descend(json_, rule.path, root, rule);
    checkCameras();
    if (unsound_.empty()) return {};
    for (const Optional& optional : kOptional) replace(json_, optional.path, "", optional);
    return std::move(unsound_);
  }

 private:
  /// Follows `path` from `json`, which stands at `place`.
  void descend(Json& json, std::string_view path, const Place& place, const Rule& rule) {
    if (path.empty()) return check(json, place, rule);
    if (path[0] == '[') return eachElement(json, path.substr(2), place, rule);
    if (path[0] == '.') path.remove_prefix(1);
    if (!json.is_object()) return;  // a rule of its own says so
    const std::size_t end = std::min(path.find_first_of(".["), path.size());
    const std::string key(path.substr(0, end));
    const std::string_view rest = path.substr(end);
    if (key == "*") {
      for (auto it = json.begin(); it != json.end(); ++it) descend(*it, rest, {&place, it.key()}, rule);
      return;
    }
    const auto member = json.find(key);
    if (member != json.end()) return descend(*member, rest, {&place, key}, rule);
    if (rest.empty() && rule.required) fail(Place{&place, key}.text(), expected(rule), "nothing");
  }

  void eachElement(Json& list, std::string_view rest, const Place& place, const Rule& rule) {
    if (!list.is_array()) return fail(place.text(), "an array", shortened(list));
    for (std::size_t i = 0; i < list.size(); ++i) descend(list[i], rest, {&place, {}, i}, rule);
  }

  void check(Json& value, const Place& place, const Rule& rule) {
    if (!fits(value, rule)) fail(place.text(), expected(rule), shortened(value));
  }

  /// A camera holds the object that its type names.
  void checkCameras() {
    if (!json_.contains("cameras")) return;
    for (std::size_t i = 0; i < json_["cameras"].size(); ++i) {
      const Json& camera = json_["cameras"][i];
      if (!camera.is_object()) continue;
      const auto type = camera.find("type");
      for (const char* kind : {"perspective", "orthographic"})
        if (type != camera.end() && *type == kind && !camera.contains(kind))
          fail(at("cameras", i) + "." + kind, "an object {...}", "nothing");
    }
  }

  bool fits(Json& value, const Rule& rule) {
    switch (rule.kind) {
      case Kind::object:
        return value.is_object();
      case Kind::text:
        return value.is_string();
      case Kind::flag:
        return value.is_boolean();
      case Kind::word:
        return value.is_string() && isAmong(rule.among, value.get<std::string>());
      case Kind::number:
        return value.is_number() && value >= rule.low && value <= rule.high;
      case Kind::numbers:
        return fitsNumbers(value, rule);
      case Kind::whole:
        return fitsWhole(value, rule.low, rule.high) && value.get<std::uint64_t>() % unsigned(rule.step) == 0;
      case Kind::index:
        return fitsWhole(value, 0, double(lengthOf(rule.among)) - 1);
    }
    return false;
  }

  static bool fitsNumbers(const Json& value, const Rule& rule) {
    if (!value.is_array()) return false;
    if (rule.longest &&
        (value.size() < std::size_t(rule.shortest) || value.size() > std::size_t(rule.longest)))
      return false;
    for (const Json& each : value)
      if (!each.is_number() || !(each >= rule.low) || !(each <= rule.high)) return false;
    return true;
  }

  static bool fitsWhole(Json& value, double low, double high) {
    if (!value.is_number()) return false;
    const double as = value.get<double>();
    if (!(as >= low && as <= high) || as != std::floor(as)) return false;
    if (value.is_number_float()) value = std::uint64_t(as);
    return value.is_number_unsigned() || value.get<std::int64_t>() >= 0;
  }

  std::size_t lengthOf(const char* list) const {
    const Json* json = &json_;
    for (std::string_view path = list; !path.empty();) {
      const std::size_t end = std::min(path.find('.'), path.size());
      const auto member = json->find(std::string(path.substr(0, end)));
      if (member == json->end()) return 0;
      json = &*member;
      path.remove_prefix(std::min(end + 1, path.size()));
    }
    return json->is_array() ? json->size() : 0;
  }

  std::string expected(const Rule& rule) const {
    switch (rule.kind) {
      case Kind::object:
        return "an object {...}";
      case Kind::text:
        return "a text in quotes";
      case Kind::flag:
        return "true or false";
      case Kind::word:
        return std::string("one of") + rule.among;
      case Kind::number:
        return "a number from " + number(rule.low) + " to " + number(rule.high);
      case Kind::numbers:
        return "an array of " + (rule.longest ? std::to_string(rule.longest) + " " : std::string()) +
               "numbers from " + number(rule.low) + " to " + number(rule.high);
      case Kind::whole:
        return (rule.step > 1 ? "a multiple of " + std::to_string(rule.step)
                              : std::string("a whole number")) +
               " from " + number(rule.low) + " to " + number(rule.high);
      case Kind::index:
        return "an index below " + std::to_string(lengthOf(rule.among)) + ", the number of " + rule.among;
    }
    return {};
  }

  void fail(const std::string& place, std::string expected, const std::string& got) {
    if (!expected.empty() && expected.back() == ' ') expected.pop_back();
    const std::string message = place + ": expected " + expected + ", got " + got;
    for (const Optional& optional : kOptional)
      if (const std::string element = elementOf(place, optional.path); !element.empty()) {
        unsound_.emplace(element, message);
        return;
      }
    throw sdk::BadInput(message);
  }

  /// Puts the stand-in at every unsound place of its pattern.
  void replace(Json& json, std::string_view path, const std::string& place, const Optional& optional) {
    if (path.empty()) {
      if (unsound_.count(place)) json = Json::parse(optional.standIn);
      return;
    }
    if (path[0] == '[') {
      for (std::size_t i = 0; i < json.size(); ++i) replace(json[i], path.substr(2), at(place, i), optional);
      return;
    }
    if (path[0] == '.') path.remove_prefix(1);
    const std::size_t end = std::min(path.find_first_of(".["), path.size());
    const std::string key(path.substr(0, end));
    const auto member = json.find(key);
    if (member != json.end())
      replace(*member, path.substr(end), place.empty() ? key : place + "." + key, optional);
  }

  Json& json_;
  Unsound unsound_;
};

}  // namespace

Unsound checkValues(Json& json) {
  return Checker(json).run();
}

}  // namespace gltf
