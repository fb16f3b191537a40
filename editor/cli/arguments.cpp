// SPDX-License-Identifier: MIT
// Values of options.
#include "editor/cli/arguments.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace steradian::cli {

namespace {

constexpr double kLongestSeconds = 366.0 * 24.0 * 3600.0;

/// The whole of `text` as a number, or nothing; independent of the locale.
template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if constexpr (std::is_floating_point_v<Number>)
    if (!std::isfinite(value)) return std::nullopt;
  return value;
}

[[noreturn]] void reject(const char* option, const std::string& text, const char* expected) {
  throw Error(ExitCode::usage, std::string(option) + ": '" + text + "' is not valid; expected " + expected);
}

/// "1%" or "0.01".
std::optional<double> fraction(std::string_view text) {
  const bool percent = !text.empty() && text.back() == '%';
  if (percent) text.remove_suffix(1);
  const auto value = number<double>(text);
  return value && percent ? *value / 100.0 : value;
}

/// "30", "30s", "2m", "1h".
std::optional<double> seconds(std::string_view text) {
  double unit = 1.0;
  if (!text.empty() && (text.back() == 's' || text.back() == 'm' || text.back() == 'h')) {
    unit = text.back() == 's' ? 1.0 : text.back() == 'm' ? 60.0 : 3600.0;
    text.remove_suffix(1);
  }
  const auto value = number<double>(text);
  return value ? std::optional(*value * unit) : std::nullopt;
}

}  // namespace

Extent parseSize(const std::string& text) {
  const std::string_view view(text);
  const auto x = view.find('x');
  if (x != view.npos) {
    const auto width = number<int>(view.substr(0, x)), height = number<int>(view.substr(x + 1));
    if (width && height && std::min(*width, *height) >= 1 && std::max(*width, *height) <= 16384)
      return {*width, *height};
  }
  reject("--size", text, "WIDTHxHEIGHT, each from 1 to 16384");
}

std::pair<std::uint64_t, std::uint64_t> parseSampleRange(const std::string& text) {
  const std::string_view view(text);
  const auto colon = view.find(':');
  if (colon != view.npos) {
    const auto begin = number<std::uint64_t>(view.substr(0, colon)),
               end = number<std::uint64_t>(view.substr(colon + 1));
    if (begin && end && *begin < *end) return {*begin, *end};
  }
  reject("--samples", text, "FIRST:END, two sample indices, the first less than the second");
}

void parseUntil(const std::string& text, StillRequest& request) {
  const std::string_view view(text);
  const auto value = view.rfind("rel=", 0) == 0    ? fraction(view.substr(4))
                     : view.rfind("time=", 0) == 0 ? seconds(view.substr(5))
                                                   : std::nullopt;
  const bool timed = view.rfind("time=", 0) == 0;
  if (!value || !(*value > 0.0) || (timed && *value > kLongestSeconds))
    reject("--until", text, "rel=1%, rel=0.01, time=30s, time=2m or time=1h, a year at most");
  if (!timed)
    request.untilRelRmse = std::max(*value, request.untilRelRmse.value_or(*value));
  else
    request.untilSeconds = std::min(*value, request.untilSeconds.value_or(*value));
}

std::string aboveZero(const std::string& text) {
  const auto value = number<double>(text);
  return value && *value > 0.0 ? "" : "'" + text + "' is not valid; expected a number above 0";
}

std::pair<std::string, double> parseParameter(const std::string& text) {
  const auto equals = text.find('=');
  if (equals != std::string::npos && equals > 0) {
    const std::string_view value = std::string_view(text).substr(equals + 1);
    if (value == "true" || value == "false") return {text.substr(0, equals), value == "true" ? 1.0 : 0.0};
    if (const auto parsed = number<double>(value)) return {text.substr(0, equals), *parsed};
  }
  reject("--param", text, "ID=NUMBER");
}

}  // namespace steradian::cli
