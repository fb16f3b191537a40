// SPDX-License-Identifier: MIT
// Materials and textures as glTF 2.0 and its ratified extensions say them.
#pragma once
#include <map>
#include <optional>
#include <steradian/plugin.hpp>
#include <utility>

#include "document.hpp"

namespace gltf_export {

class Materials {
 public:
  /// Writes every material and texture of the scene; what glTF cannot hold goes to Host::notKept.
  Materials(Document& document, steradian::sdk::SceneView& scene, steradian::sdk::Host& host);
  /// Index of a material by its id, for a surface with this many UV sets: textures that need more are left
  /// off, as Steradian leaves them off. nullopt for no material (0).
  std::optional<std::size_t> find(std::uint32_t id, std::uint32_t uvSets);
  /// A black body that emits `luminance` nit of this colour, for the bodies of area lights.
  std::size_t addGlow(const float (&color)[3], float luminance);

 private:
  Json textureInfo(const steradian::sdk::TextureSlotRecord& slot, std::uint32_t uvSets);
  void addImages(steradian::sdk::SceneView& scene, steradian::sdk::Host& host);
  std::size_t add(const steradian::sdk::MaterialRecord& m, std::uint32_t uvSets);
  void addTextures(Json& json, const steradian::sdk::MaterialRecord& m, std::uint32_t uvSets);
  void addExtensions(Json& json, const steradian::sdk::MaterialRecord& m);
  void addEmission(Json& json, const float (&color)[3], float luminance);

  Document& document_;
  std::map<std::uint32_t, const steradian::sdk::MaterialRecord*> records_;  // by material id
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> indices_;  // by id and UV sets
  std::map<std::uint32_t, std::size_t> images_;                             // by texture id
};

/// `extras` of a record (a JSON object or nothing), with what only Steradian knows under "steradian".
Json extrasOf(const steradian::sdk::Text& extras, Json ours);

}  // namespace gltf_export
