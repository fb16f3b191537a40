// SPDX-License-Identifier: MIT
// Checks the first bytes and hands the file to the reader module.
#include "editor/image_file.hpp"

#include <dlfcn.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "renderer/scene/error.hpp"

namespace steradian {

namespace fs = std::filesystem;

namespace {

/// "openexr", "hdr", "png" or empty.
std::string formatOf(const fs::path& path) {
  std::array<char, 8> head{};
  std::ifstream(path, std::ios::binary).read(head.data(), head.size());
  if (std::memcmp(head.data(), "\x76\x2f\x31\x01", 4) == 0) return "openexr";
  if (std::memcmp(head.data(), "\x89PNG\r\n\x1a\n", 8) == 0) return "png";
  if (std::memcmp(head.data(), "#?", 2) == 0) return "hdr";
  return {};
}

using Read = void (*)(const std::string&, const std::string&, ImageFile&, std::string&);

Read loadReader() {
  std::error_code none;
  const fs::path module =
      fs::read_symlink("/proc/self/exe", none).parent_path().parent_path() / STERADIAN_READER;
  void* library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* symbol = library ? dlsym(library, "steradianReadImage") : nullptr;
  if (!symbol)
    throw Error(ExitCode::failed,
                std::string("the image reader cannot be loaded: ") + dlerror() + "; reinstall steradian");
  return reinterpret_cast<Read>(symbol);
}

}  // namespace

bool isImage(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && !formatOf(path).empty();
}

ImageFile readImage(const fs::path& path) {
  std::error_code failure;
  if (!fs::is_regular_file(path, failure))
    throw Error(ExitCode::badInput,
                path.string() + ": " + (failure ? failure.message() : "is not a regular file"));
  if (!std::ifstream(path))
    throw Error(ExitCode::io, path.string() + ": cannot be opened: " + std::strerror(errno));
  const std::string format = formatOf(path);
  if (format.empty()) throw Error(ExitCode::badInput, path.string() + ": is not an EXR, HDR or PNG image");
  ImageFile file;
  std::string reason;
  loadReader()(path.string(), format, file, reason);
  if (!reason.empty())
    throw Error(ExitCode::badInput, path.string() + ": damaged or not readable: " + reason);
  return file;
}

}  // namespace steradian
