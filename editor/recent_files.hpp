// SPDX-License-Identifier: MIT
// The list of recently opened files, kept in the user's XDG state folder, one path per line.
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

namespace steradian {

/// $XDG_STATE_HOME/steradian (relative values are ignored, as the XDG specification asks), else
/// $HOME/.local/state/steradian; nullopt when neither is known.
std::optional<std::filesystem::path> stateFolder();

class RecentFiles {
 public:
  static constexpr std::size_t kMost = 12;

  /// Reads the list; a missing or unreadable one is empty. `file` empty = nothing is kept between runs.
  explicit RecentFiles(std::filesystem::path file = defaultFile());
  static std::filesystem::path defaultFile();

  const std::vector<std::filesystem::path>& paths() const { return paths_; }  // newest first, absolute
  /// To the front, without repeats, and written at once; a failure to write never matters to the caller.
  void add(const std::filesystem::path& path);
  void remove(const std::filesystem::path& path);
  void clear();

 private:
  void write() const noexcept;

  std::filesystem::path file_;
  std::vector<std::filesystem::path> paths_;
};

}  // namespace steradian
