// SPDX-License-Identifier: MIT
// JSON text in and out: parsed with limits and places, written one object per line.
#include "json_text.hpp"

#include <algorithm>
#include <steradian/plugin.hpp>
#include <vector>

namespace project {

namespace {

std::string placeOf(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position > 0 ? position - 1 : 0);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const auto lineStart = before.rfind('\n');
  const auto column = before.size() - (lineStart == before.npos ? 0 : lineStart + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column) + ": ";
}

/// Builds the document while it counts the nesting.
class Builder final : public Json::json_sax_t {
 public:
  Builder(std::string_view text, int deepest) : text_(text), deepest_(std::size_t(deepest)) {}
  Json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool v) override { return add(v); }
  bool number_integer(number_integer_t v) override { return add(v); }
  bool number_unsigned(number_unsigned_t v) override { return add(v); }
  bool number_float(number_float_t v, const string_t&) override { return add(v); }
  bool string(string_t& v) override { return add(std::move(v)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& v) override {
    key_ = std::move(v);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const Json::exception& error) override {
    std::string what = error.what();
    what.erase(0, what.find("] ") + 2);  // [json.exception.parse_error.101]
    if (const auto column = what.find("column "); what.rfind("parse error at line", 0) == 0)
      what.erase(0, what.find(": ", column) + 2);
    throw steradian::sdk::BadInput(placeOf(text_, position) + what);
  }

 private:
  Json* add(Json&& value, bool) {
    if (open_.empty()) return &(root_ = std::move(value));
    Json& parent = *open_.back();
    if (parent.is_object()) return &(parent[key_] = std::move(value));
    parent.push_back(std::move(value));
    return &parent.back();
  }
  bool add(Json&& value) { return add(std::move(value), true) != nullptr; }
  bool open(Json&& value) {
    if (open_.size() >= deepest_)
      throw steradian::sdk::BadInput("is nested deeper than " + std::to_string(deepest_) + " brackets");
    open_.push_back(add(std::move(value), true));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  std::size_t deepest_;
  Json root_;
  std::vector<Json*> open_;  // stay in place: a parent gets no new child while one is open
  std::string key_;
};

bool holdsObjects(const OrderedJson& json) {
  return json.is_array() &&
         std::any_of(json.begin(), json.end(), [](const auto& e) { return e.is_object(); });
}

bool spreads(const OrderedJson& json, int depth) {
  if (depth == 0 || holdsObjects(json)) return true;
  return json.is_object() &&
         std::any_of(json.begin(), json.end(), [](const auto& e) { return holdsObjects(e); });
}

void append(std::string& out, const OrderedJson& json, int depth) {
  if (!json.is_structured() || json.empty()) {
    out += json.dump();
    return;
  }
  const bool lines = spreads(json, depth);
  const std::string between = lines ? ",\n" + std::string(std::size_t(2 * depth + 2), ' ') : ", ";
  out += json.is_object() ? '{' : '[';
  if (lines) out += between.substr(1);
  bool first = true;
  for (auto it = json.begin(); it != json.end(); ++it) {
    if (!first) out += between;
    first = false;
    if (json.is_object()) out += OrderedJson(it.key()).dump() + ": ";
    append(out, *it, depth + 1);
  }
  if (lines) out += "\n" + std::string(std::size_t(2 * depth), ' ');
  out += json.is_object() ? '}' : ']';
}

}  // namespace

Json parseJson(std::string_view text, int deepest) {
  if (text.size() > kLargest) throw steradian::sdk::BadInput("is larger than 256 MiB");
  Builder builder(text, deepest);
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

std::string jsonText(const OrderedJson& json) {
  std::string out;
  append(out, json, 0);
  return out + "\n";
}

}  // namespace project
