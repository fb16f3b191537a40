// SPDX-License-Identifier: MIT
// Writing of one JSON object: defaults left out, the fewest digits, unknown keys handed back.
#pragma once
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "json_text.hpp"
#include "project.hpp"

namespace project {

OrderedJson number(double value);  // 5 rather than 5.0
OrderedJson number(float value);   // the fewest digits that a float reads back from

template <class Number>
OrderedJson list(const Number* values, std::size_t count) {
  OrderedJson out = OrderedJson::array();
  for (std::size_t i = 0; i < count; ++i) out.push_back(number(values[i]));
  return out;
}

/// Writes a key unless its value is the default.
class Keys {
 public:
  template <class Number>
  void put(const char* key, Number value, Number usual) {
    if (!same(value, usual)) json[key] = number(value);
  }
  template <class Number, std::size_t N>
  void put(const char* key, const Number (&values)[N], const Number (&usual)[N], std::size_t count = N) {
    if (!std::equal(values, values + count, usual, same<Number>)) json[key] = list(values, count);
  }
  void putWhole(const char* key, std::int64_t value, std::int64_t usual) {
    if (value != usual) json[key] = value;
  }
  void putFlag(const char* key, std::uint32_t value, std::uint32_t usual) {
    if ((value != 0) != (usual != 0)) json[key] = value != 0;
  }
  void putText(const char* key, const steradian::sdk::Text& value, std::string_view usual = {}) {
    if (value.view() != usual) json[key] = value.str();
  }
  OrderedJson json = OrderedJson::object();

 private:
  template <class Number>
  static bool same(Number a, Number b) {
    return a == b && std::signbit(a) == std::signbit(b);
  }
};

/// Adds the unknown keys of an earlier file. Known ones were settled above; inside of a known object that is
/// still there they are merged, so an old "sphere" does not come back on a box.
void addExtras(steradian::sdk::Host& host, OrderedJson& out, const steradian::sdk::Text& extras,
               std::initializer_list<const char*> known, bool atTop = false);

OrderedJson materialJson(steradian::sdk::Host& host, const steradian::sdk::MaterialRecord& material);
/// It has something that version 1 of the format did not know.
bool needsVersion2(const steradian::sdk::MaterialRecord& material);
OrderedJson objectJson(steradian::sdk::Host& host, const steradian::sdk::ObjectRecord& object);

}  // namespace project
