// SPDX-License-Identifier: MIT
// Materials, textures, samplers and images.
#pragma once
#include "document.hpp"

namespace gltf {

class Materials {
 public:
  Materials(const Document& document, Report& report, sdk::SceneSink& sink, std::uint32_t& nextId)
      : document_(document), report_(report), sink_(sink), nextId_(nextId) {}

  /// The id of a glTF material, pushed into the sink at its first use; -1 = glTF's default.
  std::uint32_t id(int material);

 private:
  using Extension = const tinygltf::Value*;  // null when absent

  std::uint32_t add(const tinygltf::Material& material, int index);
  void read(const tinygltf::Material& material, const std::string& name, sdk::MaterialRecord& out);
  void readCore(const tinygltf::Material& material, const std::string& name, sdk::MaterialRecord& out);
  void readTransmission(const tinygltf::Material& material, const std::string& name,
                        sdk::MaterialRecord& out);
  void readCoats(const tinygltf::Material& material, const std::string& name, sdk::MaterialRecord& out);
  void readUnlit(const std::string& name, sdk::MaterialRecord& out);
  /// A texture of an extension that has no counterpart here.
  void dropTexture(Extension extension, const char* key, const std::string& name);

  template <class Info>
  sdk::TextureSlotRecord slot(const Info& info, const std::string& what);
  std::uint32_t textureId(int image);
  void readSampler(int sampler, sdk::TextureSlotRecord& out);

  const Document& document_;
  Report& report_;
  sdk::SceneSink& sink_;
  std::uint32_t& nextId_;
  std::map<int, std::uint32_t> ids_, textures_;
};

}  // namespace gltf
