// SPDX-License-Identifier: MIT
// Frozen: the interface 1.0 as it was shipped, so that a test can build a plugin of that age. Never change
// it. Pixels that cross the plugin border.
#pragma once
#include <steradian/records.hpp>

namespace steradian::sdk {

/// An array element: never grows.
struct MetadataRecord {
  Text key = {};
  Text value = {};
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
};

}  // namespace steradian::sdk
