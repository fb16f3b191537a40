// SPDX-License-Identifier: MIT
// Textures, and meshes that carry them, for tests.
#pragma once
#include <cstring>
#include <functional>
#include <glm/gtc/packing.hpp>

#include "renderer/scene/texture.hpp"
#include "tests/renderer/meshes.hpp"

namespace steradian::textures {

using Format = TexturePixels::Format;

/// `texel(x, y)`: the stored components in [0, 1], or what they are for half floats.
inline std::shared_ptr<const Texture> made(int width, int height, Format format,
                                           const std::function<glm::vec4(int, int)>& texel) {
  auto texture = std::make_shared<Texture>();
  texture->pixels.format = format;
  texture->pixels.width = width;
  texture->pixels.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 4; ++c) {
        const float v = texel(x, y)[c];
        const auto code = format == Format::rgbaHalf
                              ? glm::packHalf1x16(v)
                              : std::uint16_t(std::lround(v * (format == Format::rgba8 ? 255.0f : 65535.0f)));
        texture->pixels.bytes.push_back(std::uint8_t(code));
        if (format != Format::rgba8) texture->pixels.bytes.push_back(std::uint8_t(code >> 8));
      }
  return texture;
}

inline TextureSlot slot(std::shared_ptr<const Texture> texture, bool nearest = true) {
  TextureSlot made;
  made.texture = std::move(texture);
  made.nearest = nearest;
  return made;
}

/// One colour all over.
inline TextureSlot uniform(glm::vec4 value, Format format = Format::rgbaHalf) {
  return slot(made(1, 1, format, [&](int, int) { return value; }));
}

/// |x|, |y| <= 1 at z = 0, facing +Z, its texture upright.
inline Mesh picture() {
  Mesh mesh;
  mesh.positions = {{-1, 1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};
  mesh.triangles = {{0, 3, 2}, {0, 2, 1}};
  mesh.uv0 = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return mesh;
}

inline MeshShape shape(Mesh mesh) {
  return MeshShape{sharedMesh(std::move(mesh))};
}

/// With the sphere's own normals.
inline Mesh smoothBall(int levels) {
  Mesh mesh = meshes::icosphere(levels);
  mesh.normals = mesh.positions;
  return mesh;
}

}  // namespace steradian::textures
