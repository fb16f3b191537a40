// SPDX-License-Identifier: MIT
// Float pixels in host memory.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace steradian {

/// Row-major from the top left, `channels` floats per pixel. Scene-linear Rec. 709 unless said otherwise.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> pixels;  // width * height * channels

  float* at(int x, int y) { return &pixels[(std::size_t(y) * width + x) * channels]; }
  const float* at(int x, int y) const { return &pixels[(std::size_t(y) * width + x) * channels]; }
  bool operator==(const Image&) const = default;
};

}  // namespace steradian
