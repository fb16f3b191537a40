// SPDX-License-Identifier: MIT
// Reads images: for `compare`, `info` and skies. The reader lives in a module of its own, loaded at first
// use: its image library takes a quarter of a second to load, which no other command should pay.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "renderer/scene/image.hpp"

namespace steradian {

struct ImageFile {
  Image image;                            // all channels as float; EXR and HDR scene-linear
  std::vector<std::string> channelNames;  // "R", "albedo.R" ...
  std::string format;                     // "openexr", "hdr", "png"
  std::map<std::string, std::string> metadata;
};

/// EXR, Radiance HDR or PNG, by the first bytes, never by the name. Throws Error(badInput | io) naming the
/// file.
ImageFile readImage(const std::filesystem::path& path);
bool isImage(const std::filesystem::path& path);  // by the first bytes; false also when unreadable

}  // namespace steradian
