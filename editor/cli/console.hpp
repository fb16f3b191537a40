// SPDX-License-Identifier: MIT
// Messages on stderr; results go to stdout by whoever has them.
#pragma once
#include <string>

namespace steradian::cli {

bool stderrIsTerminal();

// One line each, "steradian: warning: ..."; coloured on a terminal unless NO_COLOR is set or TERM is dumb.
void note(const std::string& text);
void warn(const std::string& text);
void fail(const std::string& text);

/// printf into a string; numbers for people.
[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);
std::string duration(double seconds);  // "0.84 s", "3 min 12 s", "2 h 05 min"
std::string percent(double fraction);  // "0.85 %"

/// Seconds since this process was started, its loading by the system included.
double secondsSinceStart();

}  // namespace steradian::cli
