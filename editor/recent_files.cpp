// SPDX-License-Identifier: MIT
// Recent files, stored in the XDG state folder.
#include "editor/recent_files.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

namespace steradian {

namespace fs = std::filesystem;

std::optional<fs::path> stateFolder() {
  const char* xdg = std::getenv("XDG_STATE_HOME");
  if (xdg && fs::path(xdg).is_absolute()) return fs::path(xdg) / "steradian";
  const char* home = std::getenv("HOME");
  if (home && fs::path(home).is_absolute()) return fs::path(home) / ".local" / "state" / "steradian";
  return std::nullopt;
}

fs::path RecentFiles::defaultFile() {
  const auto folder = stateFolder();
  return folder ? *folder / "recent" : fs::path();
}

RecentFiles::RecentFiles(fs::path file) : file_(std::move(file)) {
  std::ifstream stream(file_);
  std::string line;
  while (paths_.size() < kMost && std::getline(stream, line)) {
    const fs::path path(line);
    if (path.is_absolute() && std::find(paths_.begin(), paths_.end(), path) == paths_.end())
      paths_.push_back(path);
  }
}

void RecentFiles::add(const fs::path& path) {
  std::error_code ignored;
  fs::path absolute = fs::absolute(path, ignored).lexically_normal();
  // A line is an entry, so a name with a line break in it cannot be kept.
  if (ignored || absolute.native().find('\n') != std::string::npos) return;
  std::erase(paths_, absolute);
  paths_.insert(paths_.begin(), std::move(absolute));
  if (paths_.size() > kMost) paths_.resize(kMost);
  write();
}

void RecentFiles::remove(const fs::path& path) {
  if (std::erase(paths_, path) > 0) write();
}

void RecentFiles::clear() {
  paths_.clear();
  write();
}

void RecentFiles::write() const noexcept try {
  if (file_.empty()) return;
  fs::create_directories(file_.parent_path());
  const fs::path temporary = file_.string() + "." + std::to_string(::getpid()) + ".tmp";
  std::ofstream stream(temporary);
  for (const fs::path& path : paths_) stream << path.native() << '\n';
  stream.close();
  std::error_code ignored;
  if (stream)
    fs::rename(temporary, file_, ignored);
  else
    fs::remove(temporary, ignored);
} catch (const std::exception&) {
  // The list is a convenience; losing it must not stop an open or a save.
}

}  // namespace steradian
