// SPDX-License-Identifier: MIT
// Checks the first bytes and hands the file to the reader module.
#include "editor/image_file.hpp"

#include <dlfcn.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>

#include "renderer/scene/error.hpp"

namespace steradian {

namespace fs = std::filesystem;

namespace {

/// "openexr", "hdr", "png", "jpeg" or empty.
std::string formatOf(std::string_view head) {
  if (head.starts_with("\x76\x2f\x31\x01")) return "openexr";
  if (head.starts_with("\x89PNG\r\n\x1a\n")) return "png";
  if (head.starts_with("\xff\xd8\xff")) return "jpeg";
  if (head.starts_with("#?")) return "hdr";
  return {};
}

std::string formatOf(const fs::path& path) {
  std::array<char, 8> head{};
  std::ifstream(path, std::ios::binary).read(head.data(), head.size());
  return formatOf(std::string_view(head.data(), head.size()));
}

using ReadImage = void(const std::string&, const std::string&, ImageFile&, std::string&);
using ReadTexture = void(const void*, std::size_t, const std::string&, TexturePixels&, std::string&);

template <class Function>
Function* reader(const char* name) {
  std::error_code none;
  const fs::path module =
      fs::read_symlink("/proc/self/exe", none).parent_path().parent_path() / STERADIAN_READER;
  void* library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* symbol = library ? dlsym(library, name) : nullptr;
  if (!symbol)
    throw Error(ExitCode::failed,
                std::string("the image reader cannot be loaded: ") + dlerror() + "; reinstall steradian");
  return reinterpret_cast<Function*>(symbol);
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
  if (format.empty())
    throw Error(ExitCode::badInput, path.string() + ": is not an EXR, HDR, PNG or JPEG image");
  ImageFile file;
  std::string reason;
  reader<ReadImage>("steradianReadImage")(path.string(), format, file, reason);
  if (!reason.empty())
    throw Error(ExitCode::badInput, path.string() + ": damaged or not readable: " + reason);
  return file;
}

TexturePixels decodeTexture(std::span<const std::uint8_t> bytes) {
  const std::string format =
      formatOf(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  if (format.empty()) throw Error(ExitCode::badInput, "is not a PNG, JPEG, HDR or EXR image");
  TexturePixels pixels;
  std::string reason;
  reader<ReadTexture>("steradianReadTexture")(bytes.data(), bytes.size(), format, pixels, reason);
  if (!reason.empty()) throw Error(ExitCode::badInput, "is damaged or not readable: " + reason);
  return pixels;
}

}  // namespace steradian
