// SPDX-License-Identifier: MIT
#include "renderer/gpu_textures.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <string>

#include "renderer/scene/error.hpp"
#include "renderer/texel_codec.hpp"
#include "shaders/gpu_types.h"

namespace steradian {
namespace {

using namespace gpu;

/// A level in linear light.
struct Level {
  std::uint32_t width, height;
  std::vector<glm::vec4> texels;
};

/// Source texels below target texel i of n, with their shares: at most three of them for a halved side.
struct Taps {
  std::uint32_t first = 0, count = 0;
  float shares[3] = {};

  Taps(std::uint32_t i, std::uint32_t n, std::uint32_t sourceSize) {
    const double scale = double(sourceSize) / n, begin = i * scale, end = begin + scale;
    first = std::uint32_t(begin);
    count = std::min(sourceSize - first, 3u);
    for (std::uint32_t k = 0; k < count; ++k) {
      const double from = std::max(begin, double(first + k)), to = std::min(end, double(first + k + 1));
      shares[k] = float(std::max(to - from, 0.0) / scale);
    }
  }
};

template <class Read>
Level halved(std::uint32_t width, std::uint32_t height, const Read& read) {
  Level level{std::max(width / 2, 1u), std::max(height / 2, 1u), {}};
  level.texels.reserve(std::size_t(level.width) * level.height);
  std::vector<Taps> columns;
  for (std::uint32_t x = 0; x < level.width; ++x) columns.emplace_back(x, level.width, width);
  for (std::uint32_t y = 0; y < level.height; ++y) {
    const Taps rows(y, level.height, height);
    for (const Taps& across : columns) {
      glm::vec4 sum(0.0f);
      for (std::uint32_t j = 0; j < rows.count; ++j)
        for (std::uint32_t i = 0; i < across.count; ++i)
          sum += read(across.first + i, rows.first + j) * (rows.shares[j] * across.shares[i]);
      level.texels.push_back(sum);
    }
  }
  return level;
}

std::size_t bytesOf(const TexturePixels& pixels) {
  const std::size_t components = std::size_t(pixels.width) * std::size_t(pixels.height) * 4;
  return components * (pixels.format == TexturePixels::Format::rgba8 ? 1 : 2);
}

std::vector<std::uint32_t> wordsOf(const TexturePixels& pixels) {
  assert(pixels.bytes.size() == bytesOf(pixels));
  std::vector<std::uint32_t> words(pixels.bytes.size() / 4);
  std::memcpy(words.data(), pixels.bytes.data(), pixels.bytes.size());
  return words;
}

/// What has no half floats ends at 1, and need not be looked through.
float brightestOf(const TexelCodec& codec, const std::vector<std::uint32_t>& words) {
  if ((codec.bits() & TEXEL_FORMAT_MASK) != TEXEL_HALF) return 1.0f;
  float most = 0.0f;
  for (std::size_t at = 0; at < words.size(); at += codec.wordsPerTexel()) {
    const glm::vec4 texel = codec.decode(&words[at]);
    most = std::max({most, texel.x, texel.y, texel.z});
  }
  return most;
}

bool isSrgb16(const PackedTexture& texture) {
  return (texture.bits & (TEXEL_FORMAT_MASK | TEXEL_SRGB)) == (TEXEL_RGBA16 | TEXEL_SRGB);
}

}  // namespace

bool isUsable(const TextureSlot& slot) {
  if (!slot.texture) return false;
  const TexturePixels& pixels = slot.texture->pixels;
  return pixels.width > 0 && pixels.height > 0 && pixels.bytes.size() == bytesOf(pixels);
}

PackedTexture packTexture(const TexturePixels& pixels, bool srgb) {
  const TexelCodec codec(pixels.format, srgb);
  const std::size_t size = codec.wordsPerTexel();
  PackedTexture packed;
  packed.width = std::uint32_t(pixels.width);
  packed.height = std::uint32_t(pixels.height);
  packed.levels = std::uint32_t(std::bit_width(std::max(packed.width, packed.height)));
  packed.bits = codec.bits();
  const std::vector<std::uint32_t> source = wordsOf(pixels);
  packed.words.resize(packed.levels);
  packed.words[0] = packed.levels;
  packed.words.insert(packed.words.end(), source.begin(), source.end());
  packed.brightest = brightestOf(codec, source);
  Level level{packed.width, packed.height, {}};
  for (std::uint32_t i = 1; i < packed.levels; ++i) {
    level = i == 1 ? halved(level.width, level.height,
                            [&](std::size_t x, std::size_t y) {
                              return codec.decode(&source[(y * packed.width + x) * size]);
                            })
                   : halved(level.width, level.height,
                            [&](std::size_t x, std::size_t y) { return level.texels[y * level.width + x]; });
    packed.words[i] = std::uint32_t(packed.words.size());
    packed.words.resize(packed.words.size() + level.texels.size() * size);
    for (std::size_t t = 0; t < level.texels.size(); ++t)
      codec.encode(level.texels[t], &packed.words[packed.words[i] + t * size]);
  }
  return packed;
}

std::shared_ptr<const PackedTexture> TextureCache::of(const std::shared_ptr<const Texture>& texture,
                                                      bool srgb) {
  const bool decoded = srgb && texture->pixels.format != TexturePixels::Format::rgbaHalf;
  return (decoded ? srgb_ : linear_).of(texture, [&] { return packTexture(texture->pixels, decoded); });
}

std::size_t TextureCache::bytesOf(const Texture& texture) const {
  std::size_t words = 0;
  for (const auto* meaning : {&linear_, &srgb_})
    if (const auto packed = meaning->find(&texture)) words += packed->words.size();
  return words * sizeof(std::uint32_t);
}

void TextureCache::forgetUnused() {
  linear_.forgetUnused();
  srgb_.forgetUnused();
}

TexturePlaces::TexturePlaces(const Scene& scene, TextureCache& cache) {
  cache.forgetUnused();
  for (const Material& m : scene.materials) {
    place(m.albedoTexture, true, cache);
    place(m.metallicRoughnessTexture, false, cache);
    place(m.normalTexture, false, cache);
    place(m.emissionTexture, true, cache);
  }
  std::size_t next = texelTables(textures_).size();
  for (std::size_t i = 0; i < textures_.size(); ++i) {
    for (auto& [key, place] : places_)
      if (place.index == i) place.firstWord = std::uint32_t(next);
    next += textures_[i]->words.size();
  }
  if (next > 0xffffffffu)
    throw Error(ExitCode::badInput, "The textures of this scene need " + std::to_string(next >> 28) +
                                        " GiB, 16 GiB is the most; use smaller images.");
}

void TexturePlaces::place(const TextureSlot& slot, bool srgb, TextureCache& cache) {
  if (!isUsable(slot) || places_.contains({slot.texture.get(), srgb})) return;
  const auto packed = cache.of(slot.texture, srgb);
  auto at = std::find(textures_.begin(), textures_.end(), packed);
  places_[{slot.texture.get(), srgb}].index = std::size_t(at - textures_.begin());
  if (at == textures_.end()) textures_.push_back(packed);
}

std::uint32_t TexturePlaces::ref(const TextureSlot& slot, bool srgb, std::vector<glm::vec4>& rows) const {
  if (!isUsable(slot)) return 0;
  const Place& place = places_.at({slot.texture.get(), srgb});
  const PackedTexture& t = *textures_[place.index];
  const std::uint32_t bits = t.bits | t.levels << TEXEL_LEVELS_SHIFT | (slot.nearest ? TEXEL_NEAREST : 0u) |
                             (slot.uvSet == 1 ? TEXEL_UV1 : 0u) |
                             std::uint32_t(slot.wrapU) << TEXEL_WRAP_U_SHIFT |
                             std::uint32_t(slot.wrapV) << TEXEL_WRAP_V_SHIFT;
  const auto asFloat = [](std::uint32_t word) { return std::bit_cast<float>(word); };
  const std::uint32_t row = std::uint32_t(rows.size());
  rows.emplace_back(asFloat(place.firstWord), asFloat(t.width), asFloat(t.height), asFloat(bits));
  rows.emplace_back(slot.transformX, 0.0f);
  rows.emplace_back(slot.transformY, 0.0f);
  return row;
}

TextureRefs TexturePlaces::refs(const Material& m, std::vector<glm::vec4>& rows) {
  if (const auto known = refs_.find(m.id); known != refs_.end()) return known->second;
  const TextureRefs made(ref(m.albedoTexture, true, rows), ref(m.metallicRoughnessTexture, false, rows),
                         ref(m.normalTexture, false, rows), ref(m.emissionTexture, true, rows));
  refs_[m.id] = made;
  return made;
}

std::vector<std::uint32_t> texelTables(const std::vector<std::shared_ptr<const PackedTexture>>& textures) {
  if (textures.empty()) return {};
  const bool sixteen = std::ranges::any_of(textures, [](const auto& t) { return isSrgb16(*t); });
  std::vector<float> values = srgbTable(256);
  if (sixteen) {
    const std::vector<float> fine = srgbTable(65536);
    values.insert(values.end(), fine.begin(), fine.end());
  }
  std::vector<std::uint32_t> words(values.size());
  std::ranges::transform(values, words.begin(), [](float v) { return std::bit_cast<std::uint32_t>(v); });
  return words;
}

}  // namespace steradian
