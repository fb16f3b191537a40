// SPDX-License-Identifier: MIT
// Texels of every stored format to linear light and back.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "renderer/scene/texture.hpp"

namespace steradian {

/// IEC 61966-2-1, piecewise: code value in [0, 1] to linear light, and back.
double linearFromSrgb(double code);
double srgbFromLinear(double linear);

/// What each of `codes` evenly spaced sRGB codes means in linear light.
std::vector<float> srgbTable(std::size_t codes);

/// Components of one format; `srgb` applies to RGB of the unsigned formats, never to alpha.
class TexelCodec {
 public:
  TexelCodec(TexturePixels::Format format, bool srgb);
  std::size_t wordsPerTexel() const { return format_ == TexturePixels::Format::rgba8 ? 1 : 2; }
  /// TEXEL_* bits of the format.
  std::uint32_t bits() const;
  /// The texel that starts at `words`, linear.
  glm::vec4 decode(const std::uint32_t* words) const;
  /// The nearest texel.
  void encode(const glm::vec4& linear, std::uint32_t* words) const;

 private:
  TexturePixels::Format format_;
  bool srgb_;
  std::span<const float> table_;
};

}  // namespace steradian
