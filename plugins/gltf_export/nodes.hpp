// SPDX-License-Identifier: MIT
// Objects as nodes with meshes, lights and cameras; channels as an animation.
#pragma once
#include <map>
#include <steradian/plugin.hpp>
#include <utility>

#include "document.hpp"
#include "materials.hpp"

namespace gltf_export {

class Nodes {
 public:
  Nodes(Document& document, Materials& materials, steradian::sdk::SceneView& scene,
        steradian::sdk::Host& host)
      : document_(document), materials_(materials), scene_(scene), host_(host) {}
  /// Nodes in the order of the objects, the scene that holds them, and the animation.
  void write();

 private:
  Json node(const steradian::sdk::ObjectRecord& o);
  void addContent(Json& node, const steradian::sdk::ObjectRecord& o);
  void addMesh(Json& node, const steradian::sdk::ObjectRecord& o);
  void addSurface(Json& node, const steradian::sdk::ObjectRecord& o);
  void addLight(Json& node, const steradian::sdk::ObjectRecord& o);
  void addCamera(Json& node, const steradian::sdk::ObjectRecord& o);
  Json attributes(const steradian::sdk::MeshRecord& mesh);
  void link(std::vector<Json>& nodes);
  void addAnimation();

  Document& document_;
  Materials& materials_;
  steradian::sdk::SceneView& scene_;
  steradian::sdk::Host& host_;
  std::map<std::uint32_t, std::size_t> indexOf_;                           // node by object id
  std::map<std::uint32_t, std::pair<Json, std::size_t>> primitives_;       // attributes, indices by mesh id
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> meshes_;  // by mesh and material id
};

/// What glTF has no word for, to restore the object exactly: kind, sizes, light and lens; empty for plain
/// nodes.
Json exactObject(const steradian::sdk::ObjectRecord& o);

}  // namespace gltf_export
