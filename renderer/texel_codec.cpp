// SPDX-License-Identifier: MIT
#include "renderer/texel_codec.hpp"

#include <cmath>
#include <glm/gtc/packing.hpp>

#include "shaders/gpu_types.h"

namespace steradian {
namespace {

using Format = TexturePixels::Format;

const std::vector<float>& tableOf(Format format) {
  static const std::vector<float> eight = srgbTable(256), sixteen = srgbTable(65536);
  return format == Format::rgba8 ? eight : sixteen;
}

std::uint32_t codeOf(float value, float most) {
  return std::uint32_t(std::lround(glm::clamp(value, 0.0f, 1.0f) * most));
}

}  // namespace

double linearFromSrgb(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

double srgbFromLinear(double linear) {
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

std::vector<float> srgbTable(std::size_t codes) {
  std::vector<float> table(codes);
  for (std::size_t i = 0; i < codes; ++i) table[i] = float(linearFromSrgb(double(i) / double(codes - 1)));
  return table;
}

TexelCodec::TexelCodec(Format format, bool srgb)
    : format_(format), srgb_(srgb && format != Format::rgbaHalf) {
  if (srgb_) table_ = tableOf(format);
}

std::uint32_t TexelCodec::bits() const {
  const std::uint32_t format = format_ == Format::rgba8    ? gpu::TEXEL_RGBA8
                               : format_ == Format::rgba16 ? gpu::TEXEL_RGBA16
                                                           : gpu::TEXEL_HALF;
  return format | (srgb_ ? gpu::TEXEL_SRGB : 0u);
}

glm::vec4 TexelCodec::decode(const std::uint32_t* words) const {
  if (format_ == Format::rgbaHalf) return {glm::unpackHalf2x16(words[0]), glm::unpackHalf2x16(words[1])};
  const bool eight = format_ == Format::rgba8;
  glm::vec4 linear;
  for (int i = 0; i < 4; ++i) {
    const std::uint32_t code =
        eight ? (words[0] >> (8 * i)) & 255u : (words[i / 2] >> (16 * (i % 2))) & 65535u;
    linear[i] = srgb_ && i < 3 ? table_[code] : float(code) / (eight ? 255.0f : 65535.0f);
  }
  return linear;
}

void TexelCodec::encode(const glm::vec4& linear, std::uint32_t* words) const {
  if (format_ == Format::rgbaHalf) {
    words[0] = glm::packHalf2x16(glm::vec2(linear.x, linear.y));
    words[1] = glm::packHalf2x16(glm::vec2(linear.z, linear.w));
    return;
  }
  const bool eight = format_ == Format::rgba8;
  std::uint32_t codes[4];
  for (int i = 0; i < 4; ++i)
    codes[i] =
        codeOf(srgb_ && i < 3 ? float(srgbFromLinear(linear[i])) : linear[i], eight ? 255.0f : 65535.0f);
  words[0] = eight ? codes[0] | codes[1] << 8 | codes[2] << 16 | codes[3] << 24 : codes[0] | codes[1] << 16;
  if (!eight) words[1] = codes[2] | codes[3] << 16;
}

}  // namespace steradian
