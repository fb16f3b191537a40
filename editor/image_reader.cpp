// SPDX-License-Identifier: MIT
// The module behind readImage(): decodes EXR, HDR and PNG through OpenImageIO, only by the format that was
// asked for.
#include <OpenImageIO/imageio.h>

#include <memory>

#include "editor/image_file.hpp"

namespace {

using steradian::ImageFile;

// Larger claims of a header are refused before any memory is taken.
constexpr std::int64_t kMostPixels = std::int64_t(1) << 28;
constexpr int kMostChannels = 64;

std::string decode(const std::string& path, const std::string& format, ImageFile& file) {
  const auto input = OIIO::ImageInput::create(format);
  if (!input) return "this build reads no " + format + ": " + OIIO::geterror();
  OIIO::ImageSpec spec;
  if (!input->open(path, spec)) return input->geterror();
  if (spec.width < 1 || spec.height < 1 || std::int64_t(spec.width) * spec.height > kMostPixels ||
      spec.nchannels < 1 || spec.nchannels > kMostChannels)
    return "claims " + std::to_string(spec.width) + "x" + std::to_string(spec.height) + " pixels of " +
           std::to_string(spec.nchannels) + " channels; at most 2^28 pixels of 64 channels are read";
  file.image = {spec.width, spec.height, spec.nchannels, {}};
  file.image.pixels.resize(std::size_t(spec.width) * spec.height * spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, file.image.pixels.data()))
    return input->geterror();
  file.channelNames = spec.channelnames;
  file.format = format;
  for (const auto& attribute : spec.extra_attribs)
    file.metadata[attribute.name().string()] = attribute.get_string();
  return {};
}

}  // namespace

/// Empty = done; else why not. No exception leaves.
extern "C" [[gnu::visibility("default")]] void steradianReadImage(const std::string& path,
                                                                  const std::string& format, ImageFile& file,
                                                                  std::string& failure) noexcept try {
  failure = decode(path, format, file);
} catch (const std::exception& error) {
  failure = error.what();
}
