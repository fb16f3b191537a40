// SPDX-License-Identifier: MIT
// Textures -> words that shaders/texture.glsl reads: each once, with its mip levels, whatever uses it.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/identity_cache.hpp"
#include "renderer/scene/material.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian {

/// Words: for each level the number of words before it; then the levels, each row-major from the top left,
/// each the exact average of the areas of the level before, in linear light.
struct PackedTexture {
  std::uint32_t width = 0, height = 0, levels = 0;
  std::uint32_t bits = 0;  // TEXEL_* of the format
  std::vector<std::uint32_t> words;
  float brightest = 0.0f;  // red, green or blue of any texel, in linear light
};

/// `srgb`: what the codes mean (half floats are linear in any case). Linear in the number of texels.
PackedTexture packTexture(const TexturePixels& pixels, bool srgb);

/// Packed textures by identity. Any thread.
class TextureCache {
 public:
  std::shared_ptr<const PackedTexture> of(const std::shared_ptr<const Texture>& texture, bool srgb);
  /// What the texture takes on the device, in all meanings that it has; 0 before it is packed.
  std::size_t bytesOf(const Texture& texture) const;
  /// What belongs to textures that nobody holds any more.
  void forgetUnused();

 private:
  IdentityCache<Texture, PackedTexture> linear_, srgb_;
};

/// Rows of a material's texture references: albedo, metallic-roughness, normal, emission; 0 = none.
using TextureRefs = glm::uvec4;

/// All textures of a scene's materials, used or not, so that no edit of an object uploads them again.
class TexturePlaces {
 public:
  TexturePlaces(const Scene& scene, TextureCache& cache);

  /// In the order of the buffer.
  const std::vector<std::shared_ptr<const PackedTexture>>& all() const { return textures_; }
  /// Appends the material's references to `rows`, once per material.
  TextureRefs refs(const Material& material, std::vector<glm::vec4>& rows);

 private:
  void place(const TextureSlot& slot, bool srgb, TextureCache& cache);
  std::uint32_t ref(const TextureSlot& slot, bool srgb, std::vector<glm::vec4>& rows) const;

  struct Place {
    std::size_t index = 0;
    std::uint32_t firstWord = 0;
  };
  std::vector<std::shared_ptr<const PackedTexture>> textures_;
  std::map<std::pair<const Texture*, bool>, Place> places_;
  std::map<Id, TextureRefs> refs_;
};

/// Words before the first texture: tables of sRGB codes, as far as the textures need them.
std::vector<std::uint32_t> texelTables(const std::vector<std::shared_ptr<const PackedTexture>>& textures);

/// A texture that can be looked up: there, decoded, and whole.
bool isUsable(const TextureSlot& slot);

}  // namespace steradian
