// SPDX-License-Identifier: MIT
// What is heavy about scenes in the form that the device reads, made once whoever shows it: hierarchies of
// meshes, texels with their mip levels, tables of skies and of rough glass. Any thread; renderers may share
// one.
#pragma once
#include <functional>

#include "renderer/energy_table.hpp"
#include "renderer/gpu_textures.hpp"
#include "renderer/identity_cache.hpp"
#include "renderer/mesh_cache.hpp"

namespace steradian {

class SceneCache {
 public:
  MeshCache meshes;
  TextureCache textures;
  GlassTables glass;

  /// What environmentTables makes of a sky.
  std::shared_ptr<const std::vector<glm::vec4>> skyOf(const std::shared_ptr<const Image>& image);

  /// Makes what is new in `scene` ahead, so that showing it later only uploads. `goOn` is told the share that
  /// is done, 0..1, before each mesh, texture, sky and glass; false ends it early.
  void prepare(const Scene& scene, const std::function<bool(double)>& goOn);

 private:
  IdentityCache<Image, std::vector<glm::vec4>> skies_;
};

}  // namespace steradian
