// SPDX-License-Identifier: MIT
// Textures: heavy data behind a shared pointer, never copied, compared by identity; and how materials use
// them.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace steradian {

/// RGBA, row-major from the top left.
struct TexturePixels {
  enum class Format {
    rgba8,
    rgba16,
    rgbaHalf
  };  // unsigned normalized; IEEE half, scene-linear, finite, >= 0
  Format format = Format::rgba8;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;  // width * height * 4 components, little-endian
};

/// An image as a scene uses it: the file as it was (saved again unchanged), and its decoded pixels.
struct Texture {
  std::string name;
  std::string file;                   // relative to the project's folder; empty = embedded
  std::vector<std::uint8_t> encoded;  // PNG, JPEG, HDR or EXR; empty when `file` holds it
  TexturePixels pixels;               // width 0 = not decoded yet, or unusable: the slot counts as empty
};

enum class Wrap : std::uint32_t { repeat = 0, clamp = 1, mirror = 2 };

/// A texture in one place of a material.
struct TextureSlot {
  std::shared_ptr<const Texture> texture;  // null = none
  std::uint32_t uvSet = 0;                 // 0 or 1
  Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
  bool nearest = false;  // texels as blocks instead of bilinear
  // textureUv = (x.x * u + x.y * v + x.z, y.x * u + y.y * v + y.z)
  glm::vec3 transformX{1.0f, 0.0f, 0.0f}, transformY{0.0f, 1.0f, 0.0f};
  bool operator==(const TextureSlot&) const = default;  // texture by identity
};

}  // namespace steradian
