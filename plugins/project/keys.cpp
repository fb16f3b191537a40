// SPDX-License-Identifier: MIT
// Writing of one JSON object: defaults left out, the fewest digits, unknown keys handed back.
#include "keys.hpp"

#include <charconv>

namespace project {

namespace sdk = steradian::sdk;

/// 5 rather than 5.0; -0 keeps its sign.
OrderedJson number(double value) {
  const bool whole =
      value == std::floor(value) && std::abs(value) < 9e15 && !(value == 0 && std::signbit(value));
  return whole ? OrderedJson(std::int64_t(value)) : OrderedJson(value);
}

/// The double with the fewest digits that a float reads back from: 0.8, not 0.800000011920929.
OrderedJson number(float value) {
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, value);
  double shortest = value;
  std::from_chars(text, written.ptr, shortest);
  return number(float(shortest) == value ? shortest : double(value));
}

void addExtras(sdk::Host& host, OrderedJson& out, const sdk::Text& extras,
               std::initializer_list<const char*> known, bool atTop) {
  if (extras.view().empty()) return;
  Json theirs;
  try {
    theirs = parseJson(extras.view(), atTop ? kDeepest : kDeepest - 2);  // below { "objects": [
  } catch (const sdk::BadInput& error) {
    host.log("unknown keys were not saved: " + std::string(error.what()));
    return;
  }
  if (!theirs.is_object()) return;
  for (auto it = theirs.begin(); it != theirs.end(); ++it) {
    const bool isKnown = std::find(known.begin(), known.end(), it.key()) != known.end();
    const bool there = out.contains(it.key());
    if (there && out[it.key()].is_object() && it->is_object()) {
      for (auto inner = it->begin(); inner != it->end(); ++inner)
        if (!out[it.key()].contains(inner.key())) out[it.key()][inner.key()] = OrderedJson(*inner);
    } else if (!there && (!isKnown || (atTop && it->is_object()))) {
      out[it.key()] = OrderedJson(*it);
    }
  }
}

}  // namespace project
