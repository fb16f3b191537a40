// SPDX-License-Identifier: MIT
// Reads a whole regular file, and nothing that could block or never end.
#include "plugins/host/read_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "renderer/scene/error.hpp"

namespace steradian::plugins {

namespace {

struct OpenFile {
  int fd;
  ~OpenFile() { close(fd); }
};

std::string readable(std::uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f MiB", double(bytes) / (1024.0 * 1024.0));
  return text;
}

std::uint64_t checkedSize(int fd, const std::filesystem::path& path, std::uint64_t maxBytes) {
  struct stat s {};
  if (fstat(fd, &s) != 0) throw Error(ExitCode::io, path.string() + ": " + std::strerror(errno));
  if (S_ISDIR(s.st_mode)) throw Error(ExitCode::badInput, path.string() + ": is a folder; expected a file");
  if (!S_ISREG(s.st_mode))
    throw Error(ExitCode::badInput, path.string() + ": is a device or pipe; expected a regular file");
  if (std::uint64_t(s.st_size) > maxBytes)
    throw Error(ExitCode::badInput, path.string() + ": has " + readable(std::uint64_t(s.st_size)) +
                                        "; this format is read up to " + readable(maxBytes));
  return std::uint64_t(s.st_size);
}

}  // namespace

std::filesystem::path insideFolder(const std::filesystem::path& folder, const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, failed);
  const fs::path path = failed ? fs::path() : fs::weakly_canonical(root / name, failed);
  const bool inside =
      !failed && !path.lexically_relative(root).empty() && *path.lexically_relative(root).begin() != "..";
  if (name.empty() || name.find('\0') != std::string::npos || fs::path(name).is_absolute() || !inside)
    throw Error(ExitCode::badInput, "'" + name + "' does not lie inside the folder " + root.string() +
                                        "; put the file there and name it relative to it");
  return path;
}

std::string readFile(const std::filesystem::path& path, std::uint64_t maxBytes) {
  const OpenFile file{open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)};
  if (file.fd < 0)
    throw Error(ExitCode::badInput, path.string() + ": cannot be opened: " + std::strerror(errno));
  std::string bytes(checkedSize(file.fd, path, maxBytes), '\0');
  std::size_t have = 0;
  while (have < bytes.size()) {
    const ssize_t n = read(file.fd, bytes.data() + have, bytes.size() - have);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw Error(ExitCode::io, path.string() + ": cannot be read: " + std::strerror(errno));
    if (n == 0) break;  // shrunk meanwhile
    have += std::size_t(n);
  }
  bytes.resize(have);
  return bytes;
}

}  // namespace steradian::plugins
