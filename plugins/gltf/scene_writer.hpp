// SPDX-License-Identifier: MIT
// Walks one scene of a document and pushes its objects into the sink.
#pragma once
#include <optional>

#include "materials.hpp"
#include "mesh.hpp"
#include "restore.hpp"

namespace gltf {

/// What the user may choose.
struct Choices {
  int scene = -1;      // -1: the file's default
  int animation = -1;  // -1: all
  double time = 0;     // seconds: of what is baked
};

class SceneWriter {
 public:
  SceneWriter(const Document& document, Report& report, sdk::Host& host, sdk::SceneSink& sink);
  /// Throws BadInput and Cancelled.
  void write(const Choices& choices);

 private:
  struct Visit {
    std::size_t node;
    std::uint32_t parent;  // object
    glm::dmat4 world;      // of the parent
  };
  /// One thing that a node shows: it becomes the node's object, or a child of it.
  struct Content {
    sdk::ObjectRecord record;
    std::string name;
    Json kept = Json::object();
    std::string imageFile;  // of a sky
  };

  std::size_t shownScene() const;
  std::vector<std::size_t> rootsOf(int scene);
  void addNode(const Visit& visit, std::vector<Visit>& open);

  // scene_own.cpp: what extras.steradian says
  std::vector<Content> restoredContents(std::size_t node, const std::string& name, sdk::ObjectRecord& object);
  void addOwnChannels(std::vector<Track>& tracks, sdk::SceneRecord& scene);
  void addOwnChannel(const OwnChannel& channel, std::vector<Track>& tracks);
  void addActiveCamera(const Json& ours, sdk::SceneRecord& scene);
  void addSettings(const Json& ours);

  void place(const tinygltf::Node& node, const std::string& name, sdk::ObjectRecord& out);
  std::vector<Content> contentsOf(std::size_t node, const std::string& name);
  void addObjects(sdk::ObjectRecord& object, const std::string& name, Json kept,
                  std::vector<Content> contents);
  void push(sdk::ObjectRecord record, const std::string& name, const Content& content);

  // scene_meshes.cpp
  std::vector<Content> meshContents(std::size_t node, const std::string& name);
  std::optional<Content> primitiveContent(std::size_t node, std::size_t primitive, const Bend& bend,
                                          const std::string& bendKey);
  std::uint32_t meshId(const tinygltf::Primitive& primitive, const std::string& place,
                       const std::string& name, const Bend& bend, const std::string& bendKey);
  const std::vector<glm::dmat4>& jointsOfSkin(std::size_t skin);

  // lights_cameras.cpp
  void readCamera(const tinygltf::Camera& camera, Content& out);
  void readLight(const tinygltf::Light& light, const std::string& name, Content& out);

  const Document& document_;
  Report& report_;
  sdk::Host& host_;
  sdk::SceneSink& sink_;
  std::uint32_t nextId_ = 1;
  Materials materials_;
  Choices choices_;
  Pose pose_;
  std::vector<std::uint32_t> objectOf_;          // per node
  std::vector<sdk::ObjectKind> kindOf_;          // of that object
  std::map<std::string, std::uint32_t> meshes_;  // by what they are made of; 0 = left out
  std::map<std::size_t, std::vector<glm::dmat4>> skins_;
  std::uint64_t elements_ = 0;  // vertices and triangles pushed
  double aspectRatio_ = 0;      // of the first camera that says it
};

}  // namespace gltf
