// SPDX-License-Identifier: MIT
// A Scene as an exporter reads it.
#pragma once
#include <vector>

#include "plugins/host/heavy_records.hpp"
#include "renderer/scene/scene.hpp"
#include "steradian/plugin.hpp"

namespace steradian::plugins {

/// Points into `scene`, which must outlive it.
class SceneRecords final : public sdk::SceneView {
 public:
  explicit SceneRecords(const Scene& scene);
  const sdk::SceneRecord& scene() noexcept override { return scene_; }
  const sdk::RenderSettingsRecord& render() noexcept override { return render_; }
  const sdk::DisplaySettingsRecord& display() noexcept override { return display_; }
  std::uint64_t materialCount() noexcept override { return materials_.size(); }
  const sdk::MaterialRecord& material(std::uint64_t index) noexcept override { return materials_[index]; }
  std::uint64_t objectCount() noexcept override { return objects_.size(); }
  const sdk::ObjectRecord& object(std::uint64_t index) noexcept override { return objects_[index]; }
  std::uint64_t channelCount() noexcept override { return channels_.size(); }
  const sdk::ChannelRecord& channel(std::uint64_t index) noexcept override { return channels_[index]; }

  std::uint64_t meshCount() noexcept override { return heavy_.meshes.size(); }
  const sdk::MeshRecord& mesh(std::uint64_t index) noexcept override { return heavy_.meshes[index]; }
  std::uint64_t textureCount() noexcept override { return heavy_.textures.size(); }
  const sdk::TextureRecord& texture(std::uint64_t index) noexcept override { return heavy_.textures[index]; }

 private:
  void addChannel(const Channel& channel);

  HeavyRecords heavy_;
  sdk::SceneRecord scene_;
  sdk::RenderSettingsRecord render_;
  sdk::DisplaySettingsRecord display_;
  std::vector<sdk::ParameterValue> parameters_;
  std::vector<sdk::MaterialRecord> materials_;
  std::vector<sdk::ObjectRecord> objects_;
  std::vector<sdk::ChannelRecord> channels_;
  std::vector<std::vector<sdk::Key>> keys_;
};

}  // namespace steradian::plugins
