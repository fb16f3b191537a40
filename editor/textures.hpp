// SPDX-License-Identifier: MIT
// The textures of materials: from encoded bytes or a file to pixels, shared between all who use them.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "renderer/scene/scene.hpp"

namespace steradian {

/// Every texture that the materials use, once, in their order.
std::vector<std::shared_ptr<const Texture>> texturesOf(const Scene& scene);

/// Gives every texture that names a file the name newName(file); those that keep theirs keep their pointer.
void renameTextures(Scene& scene, const std::function<std::string(const std::string&)>& newName);

/// Decodes the textures of scenes. One thread at a time; decodes on all cores.
class Textures {
 public:
  /// Puts a texture with pixels in the place of every one without; equal bytes are decoded once, and equal
  /// textures that some scene still holds keep their pointer. One line for each that cannot be used: its
  /// slots stay as they are and count as empty. `folder` is what Texture::file is relative to.
  std::vector<std::string> load(Scene& scene, const std::filesystem::path& folder);

 private:
  using Content = std::pair<std::uint64_t, std::uint64_t>;  // size and hash of the encoded bytes
  struct Wanted;
  void decode(std::vector<Wanted>& wanted);
  std::shared_ptr<const Texture> known(const Content& content, const Texture& like) const;

  std::multimap<Content, std::weak_ptr<const Texture>> decoded_;
};

}  // namespace steradian
