// SPDX-License-Identifier: MIT
// Where plugins are looked for, first to last.
#include <cstdlib>
#include <sstream>

#include "plugins/host/plugin_host.hpp"

namespace steradian::plugins {

namespace fs = std::filesystem;

namespace {

void addList(std::vector<fs::path>& out, const char* colonSeparated) {
  std::istringstream list(colonSeparated ? colonSeparated : "");
  for (std::string entry; std::getline(list, entry, ':');)
    if (!entry.empty()) out.emplace_back(entry);
}

/// $XDG_DATA_HOME, or its default; a relative value is ignored, as the XDG specification asks.
fs::path dataHome() {
  if (const char* xdg = std::getenv("XDG_DATA_HOME"); xdg && xdg[0] == '/') return xdg;
  const char* home = std::getenv("HOME");
  return home && home[0] == '/' ? fs::path(home) / ".local/share" : fs::path();
}

/// Beside the running binary: the build tree and an installed tree have the same shape.
void addInstalled(std::vector<fs::path>& out) {
  std::error_code none;
  const fs::path binary = fs::read_symlink("/proc/self/exe", none);
  if (none) return;
  const fs::path prefix = binary.parent_path().parent_path();
  for (const char* libraries : {"lib", STERADIAN_LIBDIR}) {
    const fs::path folder = prefix / libraries / "steradian/plugins";
    if (fs::is_directory(folder, none)) {
      out.push_back(folder);
      return;
    }
  }
}

}  // namespace

std::vector<fs::path> defaultSearchPath(const std::vector<fs::path>& extra) {
  std::vector<fs::path> path = extra;
  addList(path, std::getenv("STERADIAN_PLUGIN_PATH"));
  if (const fs::path home = dataHome(); !home.empty()) path.push_back(home / "steradian/plugins");
  addInstalled(path);
  return path;
}

}  // namespace steradian::plugins
