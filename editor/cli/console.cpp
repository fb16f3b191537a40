// SPDX-License-Identifier: MIT
// Messages, and numbers for people.
#include "editor/cli/console.hpp"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace steradian::cli {

namespace {

bool coloured() {
  const char* off = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return stderrIsTerminal() && !(off && *off) && !(terminal && !std::strcmp(terminal, "dumb"));
}

void line(const char* kind, const char* colour, const std::string& text) {
  const bool colours = coloured() && *colour;
  std::fprintf(stderr, "steradian: %s%s%s%s\n", colours ? colour : "", kind, colours ? "\033[0m" : "",
               text.c_str());
}

double now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
}

/// Field 22 of /proc/self/stat: when the process started, in clock ticks since boot; 0 when unreadable.
double startSinceBoot() {
  std::ifstream stream("/proc/self/stat");
  const std::string stat((std::istreambuf_iterator<char>(stream)), {});
  const auto afterName = stat.rfind(')');
  if (afterName == std::string::npos) return 0.0;
  std::istringstream fields(stat.substr(afterName + 1));
  std::string field;
  for (int i = 3; i <= 22; ++i) fields >> field;
  return std::strtod(field.c_str(), nullptr) / double(sysconf(_SC_CLK_TCK));
}

}  // namespace

bool stderrIsTerminal() {
  return isatty(STDERR_FILENO) == 1;
}

void note(const std::string& text) {
  line("", "", text);
}
void warn(const std::string& text) {
  line("warning: ", "\033[33m", text);
}
void fail(const std::string& text) {
  line("error: ", "\033[31m", text);
}

std::string text(const char* format, ...) {
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  std::string out(std::size_t(std::max(0, std::vsnprintf(nullptr, 0, format, arguments))), '\0');
  std::vsnprintf(out.data(), out.size() + 1, format, again);
  va_end(again);
  va_end(arguments);
  return out;
}

std::string duration(double seconds) {
  if (seconds < 9.995) return text("%.2f s", seconds);
  const auto whole = static_cast<long long>(seconds + 0.5);
  if (whole < 60) return text("%lld s", whole);
  if (whole < 3600) return text("%lld min %02lld s", whole / 60, whole % 60);
  return text("%lld h %02lld min", whole / 3600, whole / 60 % 60);
}

std::string percent(double fraction) {
  return text("%.3g %%", fraction * 100.0);
}

double secondsSinceStart() {
  // Taken once: /proc knows the start to 10 ms, the clock keeps the rest of the run exact.
  static const double start = startSinceBoot();
  return start > 0.0 ? now(CLOCK_BOOTTIME) - start : double(clock()) / CLOCKS_PER_SEC;
}

}  // namespace steradian::cli
