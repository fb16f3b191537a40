// SPDX-License-Identifier: MIT
// The module behind readImage() and decodeTexture(): decodes EXR, HDR, PNG and JPEG through OpenImageIO, only
// by the format that was asked for.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "editor/image_file.hpp"

namespace {

using steradian::ImageFile;
using steradian::TexturePixels;

// Larger claims of a header are refused before any memory is taken.
constexpr std::int64_t kMostPixels = std::int64_t(1) << 28;
constexpr int kMostChannels = 64;
// What compresses better than this is a bomb; small textures may be as flat as they like.
constexpr std::uint64_t kMostExpansion = 500, kAlwaysAllowed = 64 << 20;

std::string reasonOf(const OIIO::ImageInput& input) {
  std::string reason = input.geterror();
  std::ranges::replace(reason, '\n', ' ');
  return reason.empty() ? "no reason was given" : reason;
}

std::string refusalOf(const OIIO::ImageSpec& spec) {
  if (spec.width >= 1 && spec.height >= 1 && std::int64_t(spec.width) * spec.height <= kMostPixels &&
      spec.nchannels >= 1 && spec.nchannels <= kMostChannels)
    return {};
  return "claims " + std::to_string(spec.width) + "x" + std::to_string(spec.height) + " pixels of " +
         std::to_string(spec.nchannels) + " channels; at most 2^28 pixels of 64 channels are read";
}

std::string decode(const std::string& path, const std::string& format, ImageFile& file) {
  const auto input = OIIO::ImageInput::create(format);
  if (!input) return "this build reads no " + format + ": " + OIIO::geterror();
  OIIO::ImageSpec spec;
  if (!input->open(path, spec)) return reasonOf(*input);
  if (std::string refusal = refusalOf(spec); !refusal.empty()) return refusal;
  file.image = {spec.width, spec.height, spec.nchannels, {}};
  file.image.pixels.resize(std::size_t(spec.width) * spec.height * spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, file.image.pixels.data()))
    return reasonOf(*input);
  file.channelNames = spec.channelnames;
  file.format = format;
  for (const auto& attribute : spec.extra_attribs)
    file.metadata[attribute.name().string()] = attribute.get_string();
  return {};
}

/// One row of `channels` values per pixel as RGBA: grey thrice, no alpha as `opaque`.
template <class Value>
void expandRow(const Value* from, int channels, int width, Value opaque, Value* to) {
  for (int x = 0; x < width; ++x, from += channels, to += 4) {
    for (int c = 0; c < 3; ++c) to[c] = from[channels < 3 ? 0 : c];
    to[3] = channels == 2 ? from[1] : channels == 4 ? from[3] : opaque;
  }
}

/// Reads row by row as `Value`s and hands each, expanded, to `keep`.
template <class Value, class Keep>
bool eachRow(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, Value opaque,
             Keep&& keep) {
  // Further channels of an EXR are layers; a fourth one that is no alpha is one too.
  const int channels = spec.nchannels > 4 || (spec.nchannels == 4 && spec.alpha_channel != 3)
                           ? (spec.alpha_channel == 3 ? 4 : 3)
                           : spec.nchannels;
  constexpr int kRows = 64;  // EXR decodes bands of up to 64 rows at a time
  std::vector<Value> rows(std::size_t(spec.width) * channels * kRows), rgba(std::size_t(spec.width) * 4);
  for (int y = 0; y < spec.height; y += kRows) {
    const int end = std::min(y + kRows, spec.height);
    if (!input.read_scanlines(0, 0, spec.y + y, spec.y + end, spec.z, 0, channels, type, rows.data()))
      return false;
    for (int row = y; row < end; ++row) {
      expandRow(rows.data() + std::size_t(row - y) * spec.width * channels, channels, spec.width, opaque,
                rgba.data());
      keep(row, rgba);
    }
  }
  return true;
}

/// The same for files of tiles, which can only be read whole.
bool readTiled(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, std::vector<float>& rgba) {
  const int channels = std::min(spec.nchannels, spec.alpha_channel == 3 ? 4 : 3);
  std::vector<float> all(std::size_t(spec.width) * spec.height * channels);
  if (!input.read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, all.data())) return false;
  rgba.resize(std::size_t(spec.width) * spec.height * 4);
  expandRow(all.data(), channels, spec.width * spec.height, 1.0f, rgba.data());
  return true;
}

void toHalf(std::vector<float>& rgba, std::uint8_t* to) {
  constexpr float kLargestHalf = 65504.0f;
  for (float& value : rgba)
    value = value > 0.0f ? std::min(value, kLargestHalf) : 0.0f;  // NaN compares false
  OIIO::convert_pixel_values(OIIO::TypeDesc::FLOAT, rgba.data(), OIIO::TypeDesc::HALF, to, int(rgba.size()));
}

bool readRows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, TexturePixels& out) {
  using Format = TexturePixels::Format;
  const std::size_t rowSize = std::size_t(spec.width) * (out.format == Format::rgba8 ? 4 : 8);
  out.bytes.resize(rowSize * spec.height);
  const auto keepBytes = [&](int y, const auto& rgba) {
    std::copy_n(reinterpret_cast<const std::uint8_t*>(rgba.data()), rowSize, &out.bytes[rowSize * y]);
  };
  if (out.format == Format::rgba8)
    return eachRow(input, spec, OIIO::TypeDesc::UINT8, std::uint8_t(255), keepBytes);
  if (out.format == Format::rgba16)
    return eachRow(input, spec, OIIO::TypeDesc::UINT16, std::uint16_t(65535), keepBytes);
  if (spec.tile_width == 0)
    return eachRow(input, spec, OIIO::TypeDesc::FLOAT, 1.0f,
                   [&](int y, std::vector<float>& rgba) { toHalf(rgba, &out.bytes[rowSize * y]); });
  std::vector<float> rgba;
  if (!readTiled(input, spec, rgba)) return false;
  toHalf(rgba, out.bytes.data());
  return true;
}

std::string decodeBytes(const void* bytes, std::size_t size, const std::string& format, TexturePixels& out) {
  const auto input = OIIO::ImageInput::create(format);
  if (!input) return "this build reads no " + format + ": " + OIIO::geterror();
  OIIO::Filesystem::IOMemReader memory(const_cast<void*>(bytes), size);
  OIIO::ImageSpec spec, wanted;
  wanted.attribute("oiio:UnassociatedAlpha", 1);  // a transparent texel keeps its colour
  if (!input->set_ioproxy(&memory)) return "this build reads no " + format + " from memory";
  if (!input->open("texture." + format, spec, wanted)) return reasonOf(*input);
  if (std::string refusal = refusalOf(spec); !refusal.empty()) return refusal;
  using Format = TexturePixels::Format;
  out.format = spec.format == OIIO::TypeDesc::UINT8    ? Format::rgba8
               : spec.format == OIIO::TypeDesc::UINT16 ? Format::rgba16
                                                       : Format::rgbaHalf;
  const std::uint64_t decoded =
      std::uint64_t(spec.width) * std::uint64_t(spec.height) * (out.format == Format::rgba8 ? 4 : 8);
  if (decoded > kAlwaysAllowed && decoded / kMostExpansion > size)
    return "would grow from " + std::to_string(size) + " to " + std::to_string(decoded) +
           " bytes; more than 500 times is taken for an attack";
  if (!readRows(*input, spec, out)) return reasonOf(*input);
  out.width = spec.width;
  out.height = spec.height;
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

extern "C" [[gnu::visibility("default")]] void steradianReadTexture(const void* bytes, std::size_t size,
                                                                    const std::string& format,
                                                                    TexturePixels& out,
                                                                    std::string& failure) noexcept try {
  failure = decodeBytes(bytes, size, format, out);
} catch (const std::exception& error) {
  failure = error.what();
}
