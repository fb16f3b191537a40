// SPDX-License-Identifier: MIT
// Meshes and textures on their way across the plugin border, both ways.
#pragma once
#include <memory>
#include <unordered_map>
#include <vector>

#include "renderer/scene/scene.hpp"
#include "renderer/scene/validate.hpp"
#include "steradian/plugin.hpp"

namespace steradian::plugins {

/// What an importer pushed, by its ids; shared by all objects and materials that name them.
class HeavyBuilder {
 public:
  /// Copies; what is unsound is left out and reported under its place. Throws std::bad_alloc.
  void add(const sdk::MeshRecord& mesh, std::vector<Problem>& problems);
  void add(const sdk::TextureRecord& texture, std::vector<Problem>& problems);

  std::shared_ptr<const Mesh> mesh(std::uint32_t id) const;  // null when absent
  /// The slot; unknown textures and enumerators are reported. Textures may come after the materials that name
  /// them, so call it when everything is there.
  TextureSlot slot(const sdk::TextureSlotRecord& slot, const std::string& where,
                   std::vector<Problem>& problems) const;

 private:
  std::unordered_map<std::uint32_t, std::shared_ptr<const Mesh>> meshes_;
  std::unordered_map<std::uint32_t, std::shared_ptr<const Texture>> textures_;
};

/// Records that point into a scene's meshes and textures; each appears once, ids are 1 + index.
class HeavyRecords {
 public:
  explicit HeavyRecords(const Scene& scene);
  std::uint32_t idOf(const Mesh* mesh) const { return meshIds_.at(mesh); }
  sdk::TextureSlotRecord slot(const TextureSlot& slot) const;

  std::vector<sdk::MeshRecord> meshes;
  std::vector<sdk::TextureRecord> textures;

 private:
  void add(const Mesh& mesh);
  void add(const Texture& texture);
  std::unordered_map<const Mesh*, std::uint32_t> meshIds_;
  std::unordered_map<const Texture*, std::uint32_t> textureIds_;
};

}  // namespace steradian::plugins
