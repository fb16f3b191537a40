// SPDX-License-Identifier: MIT
// The sink: collects what an importer pushes and makes a validated Scene of it, or nothing.
#pragma once
#include <string>
#include <unordered_set>
#include <vector>

#include "plugins/host/heavy_records.hpp"
#include "renderer/scene/scene.hpp"
#include "renderer/scene/validate.hpp"
#include "steradian/plugin.hpp"

namespace steradian::plugins {

class SceneBuilder final : public sdk::SceneSink {
 public:
  void setScene(const sdk::SceneRecord& scene) noexcept override;
  void setRender(const sdk::RenderSettingsRecord& settings) noexcept override;
  void setDisplay(const sdk::DisplaySettingsRecord& settings) noexcept override;
  void addMaterial(const sdk::MaterialRecord& material) noexcept override;
  void addObject(const sdk::ObjectRecord& object) noexcept override;
  void addChannel(const sdk::ChannelRecord& channel) noexcept override;
  void addMesh(const sdk::MeshRecord& mesh) noexcept override;
  void addTexture(const sdk::TextureRecord& texture) noexcept override;

  /// The scene with nextId above every id; `problems` gets the sink's own findings and problemsOf's.
  Scene finish(std::vector<Problem>& problems);
  bool outOfMemory() const { return outOfMemory_; }

 private:
  template <class Work>
  void keeping(Work&& work) noexcept;  // nothing may be thrown into the plugin
  void linkMeshes();
  void linkTextures();
  std::string textOf(const sdk::Text& text, const std::string& where);

  struct Slots {
    sdk::TextureSlotRecord albedo, metallicRoughness, normal, emission;
  };

  Scene scene_;
  HeavyBuilder heavy_;
  std::vector<Slots> slots_;            // of each material
  std::vector<std::uint32_t> meshIds_;  // of each object; 0 = not a mesh
  std::vector<Problem> problems_;
  bool outOfMemory_ = false;
};

}  // namespace steradian::plugins
