// SPDX-License-Identifier: MIT
// Pixels that cross the plugin border.
#pragma once
#include <steradian/records.hpp>

namespace steradian::sdk {

/// An array element: never grows.
struct MetadataRecord {
  Text key = {};
  Text value = {};
};

/// More channels of the same picture, such as albedo or depth: row-major from the top left, `channelCount`
/// floats per pixel, interleaved. An array element: never grows.
struct LayerRecord {
  Text name = {};                  // "albedo"; a file names its channels NAME.R, NAME.G ...
  const Text* channels = nullptr;  // "R", "G", "B", or "Z", "id" ...; channelCount of them
  const float* pixels = nullptr;
  std::uint32_t channelCount = 0;
  std::uint32_t reserved = 0;
};

/// A finished image. Row-major from the top left, 3 floats per pixel; a pointer is null when the host lacks
/// that form. Owned by the host, valid during the call.
struct ImageRecord {
  std::uint32_t size = sizeof(ImageRecord);
  std::uint32_t width = 0;  // pixels
  std::uint32_t height = 0;
  std::uint32_t reserved = 0;
  const float* radiance = nullptr;   // scene-linear Rec. 709
  const float* displayed = nullptr;  // tonemapped and display-encoded Rec. 709, in [0, 1]
  const MetadataRecord* metadata = nullptr;
  std::uint64_t metadataCount = 0;
  const LayerRecord* layers = nullptr;  // for formats that can hold them; scene-linear, never tonemapped
  std::uint64_t layerCount = 0;
};

}  // namespace steradian::sdk
