// SPDX-License-Identifier: MIT
#include "tests/oracle/texture.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace steradian::oracle {
namespace {

using glm::dvec4;

double linearOfSrgb(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

dvec4 texel(const TexturePixels& pixels, int x, int y, bool color) {
  dvec4 value;
  for (int c = 0; c < 4; ++c) {
    const std::size_t at = (std::size_t(y) * pixels.width + x) * 4 + c;
    std::uint16_t wide = 0;
    if (pixels.format != TexturePixels::Format::rgba8) std::memcpy(&wide, &pixels.bytes[2 * at], 2);
    if (pixels.format == TexturePixels::Format::rgba8) value[c] = pixels.bytes[at] / 255.0;
    if (pixels.format == TexturePixels::Format::rgba16) value[c] = wide / 65535.0;
    if (pixels.format == TexturePixels::Format::rgbaHalf) value[c] = glm::unpackHalf1x16(wide);
    if (color && c < 3 && pixels.format != TexturePixels::Format::rgbaHalf) value[c] = linearOfSrgb(value[c]);
  }
  return value;
}

int wrapped(int i, int size, Wrap wrap) {
  const auto modulo = [](int a, int n) { return (a % n + n) % n; };
  if (wrap == Wrap::clamp) return std::clamp(i, 0, size - 1);
  if (wrap == Wrap::repeat) return modulo(i, size);
  const int there = modulo(i, 2 * size);
  return there < size ? there : 2 * size - 1 - there;
}

}  // namespace

dvec4 lookUp(const TextureSlot& slot, const glm::dvec2& uv, bool color) {
  if (!slot.texture) return dvec4(1.0);
  const TexturePixels& pixels = slot.texture->pixels;
  const glm::dvec3 place(uv, 1.0);
  const double x = glm::dot(glm::dvec3(slot.transformX), place) * pixels.width,
               y = glm::dot(glm::dvec3(slot.transformY), place) * pixels.height;
  const auto at = [&](double i, double j) {
    return texel(pixels, wrapped(int(i), pixels.width, slot.wrapU),
                 wrapped(int(j), pixels.height, slot.wrapV), color);
  };
  if (slot.nearest) return at(std::floor(x), std::floor(y));
  const double i = std::floor(x - 0.5), j = std::floor(y - 0.5);
  const dvec4 above = glm::mix(at(i, j), at(i + 1, j), x - 0.5 - i);
  const dvec4 below = glm::mix(at(i, j + 1), at(i + 1, j + 1), x - 0.5 - i);
  return glm::mix(above, below, y - 0.5 - j);
}

}  // namespace steradian::oracle
