// SPDX-License-Identifier: MIT
// Reads images: for `compare`, `info`, skies and textures. The reader lives in a module of its own, loaded at
// first use: its image library takes a quarter of a second to load, which no other command should pay.
#pragma once
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "renderer/scene/image.hpp"
#include "renderer/scene/texture.hpp"

namespace steradian {

struct ImageFile {
  Image image;                            // all channels as float; EXR and HDR scene-linear
  std::vector<std::string> channelNames;  // "R", "albedo.R" ...
  std::string format;                     // "openexr", "hdr", "png", "jpeg"
  std::map<std::string, std::string> metadata;
};

/// EXR, Radiance HDR, PNG or JPEG, by the first bytes, never by the name. Throws Error(badInput | io) naming
/// the file.
ImageFile readImage(const std::filesystem::path& path);
/// The pixels of a PNG, JPEG, HDR or EXR file's bytes, by the first of them. 8 bits stay rgba8, 16 bits
/// rgba16, floats become rgbaHalf, clamped to finite values >= 0; grey becomes RGB, no alpha becomes 1.
/// Throws Error(badInput) with the cause alone; size and expansion are checked before memory is taken. Any
/// thread.
TexturePixels decodeTexture(std::span<const std::uint8_t> bytes);

bool isImage(const std::filesystem::path& path);  // by the first bytes; false also when unreadable

}  // namespace steradian
