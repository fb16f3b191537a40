// SPDX-License-Identifier: MIT
// Walks one scene of a document and pushes its objects into the sink.
#include "scene_writer.hpp"

#include <algorithm>
#include <cmath>

#include "kept.hpp"

namespace gltf {

namespace {

constexpr std::uint32_t kMostObjects = 1u << 22;

/// The bounds of a scene's world transforms.
bool inRange(const glm::dmat4& world) {
  double size = 0;
  for (int c = 0; c < 3; ++c) size = std::max(size, glm::length(glm::dvec3(world[c])));
  const double offset = glm::length(glm::dvec3(world[3]));
  return std::isfinite(size) && size >= 1e-17 && size <= 1e17 && offset <= 1e17;
}

glm::dmat4 worldPart(const sdk::ObjectRecord& o) {
  return matrixOf(Trs{{o.translation[0], o.translation[1], o.translation[2]},
                      {o.rotation[3], o.rotation[0], o.rotation[1], o.rotation[2]},
                      {o.scale[0], o.scale[1], o.scale[2]}});
}

}  // namespace

SceneWriter::SceneWriter(const Document& document, Report& report, sdk::Host& host, sdk::SceneSink& sink)
    : document_(document),
      report_(report),
      host_(host),
      sink_(sink),
      materials_(document, report, sink, nextId_),
      objectOf_(document.model.nodes.size(), 0),
      kindOf_(document.model.nodes.size(), sdk::ObjectKind::group) {}

void SceneWriter::write(const Choices& choices) {
  choices_ = choices;
  std::vector<Track> tracks = readTracks(document_, choices.animation, report_);
  pose_ = poseAt(document_, tracks, choices.time);
  sdk::SceneRecord scene;
  const std::string extras = keptOfFile(document_, report_);
  scene.extras = extras;
  std::vector<Visit> open;
  const std::vector<std::size_t> roots = rootsOf(choices.scene);
  for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, 0, glm::dmat4(1.0)});
  for (std::size_t done = 1; !open.empty(); ++done) {
    if (host_.cancelled()) throw sdk::Cancelled{};
    const Visit visit = open.back();
    open.pop_back();
    addNode(visit, open);
    host_.progress(double(done) / double(document_.model.nodes.size()));
  }
  addOwnChannels(tracks, scene);
  addChannels(tracks, objectOf_, document_, report_, sink_);
  const auto& scenes = document_.model.scenes;
  if (shownScene() < scenes.size()) scene.name = scenes[shownScene()].name;
  scene.nextId = nextId_;
  const Json ours =
      shownScene() < scenes.size() ? oursOf(scenes[shownScene()].extras_json_string) : Json::object();
  addActiveCamera(ours, scene);
  sink_.setScene(scene);
  addSettings(ours);
}

std::size_t SceneWriter::shownScene() const {
  return std::size_t(choices_.scene >= 0 ? choices_.scene : std::max(0, document_.model.defaultScene));
}

/// The roots of the chosen scene; of a file without scenes, all there are.
std::vector<std::size_t> SceneWriter::rootsOf(int chosen) {
  const auto& scenes = document_.model.scenes;
  if (chosen >= int(scenes.size()))
    throw sdk::BadInput("has " + std::to_string(scenes.size()) + " scenes; there is no scene " +
                        std::to_string(chosen));
  std::vector<std::size_t> roots;
  if (scenes.empty()) {
    std::vector<bool> child(document_.model.nodes.size(), false);
    for (const auto& node : document_.model.nodes)
      for (const int c : node.children) child[std::size_t(c)] = true;
    for (std::size_t n = 0; n < child.size(); ++n)
      if (!child[n]) roots.push_back(n);
    return roots;
  }
  const std::size_t shown = shownScene();
  for (std::size_t s = 0; s < scenes.size(); ++s)
    if (s != shown)
      report_.dropped(named("scene", scenes[s].name, s), "one scene is imported; the parameter scene = " +
                                                             std::to_string(s) + " chooses this one");
  std::vector<bool> seen(document_.model.nodes.size(), false);
  for (const int root : scenes[shown].nodes) {
    if (seen[std::size_t(root)])
      throw sdk::BadInput(at("scenes", shown) + ".nodes: expected each node once, got " +
                          std::to_string(root) + " twice");
    seen[std::size_t(root)] = true;
    roots.push_back(std::size_t(root));
  }
  return roots;
}

void SceneWriter::addNode(const Visit& visit, std::vector<Visit>& open) {
  const tinygltf::Node& node = document_.model.nodes[visit.node];
  std::string name = node.name;
  if (name.empty() && node.mesh >= 0) name = document_.model.meshes[std::size_t(node.mesh)].name;
  if (name.empty()) name = "node " + std::to_string(visit.node);
  sdk::ObjectRecord object;
  object.parent = visit.parent;
  place(node, name, object);
  const glm::dmat4 world = visit.world * worldPart(object);
  if (!inRange(world))
    return report_.dropped("node '" + name + "' and all inside it", "its size or place is out of range");
  if (nextId_ > kMostObjects) throw sdk::BadInput("makes more than 4 million objects");
  object.id = objectOf_[visit.node] = nextId_++;
  std::vector<Content> contents = restoredContents(visit.node, name, object);
  kindOf_[visit.node] = contents.size() == 1 ? contents[0].record.kind : object.kind;
  addObjects(object, name, keptOf(node), std::move(contents));
  for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
    open.push_back({std::size_t(*child), object.id, world});
}

void SceneWriter::place(const tinygltf::Node& node, const std::string& name, sdk::ObjectRecord& out) {
  bool sheared = false;
  const Trs trs = trsOf(node, sheared);
  if (sheared) report_.approximated("node '" + name + "', matrix", "its shear is left out");
  glm::dvec3 scale = trs.scale;
  if (scale == glm::dvec3(0.0)) {  // the usual way to hide a node
    out.visible = 0;
    scale = glm::dvec3(1.0);
    report_.approximated("node '" + name + "', scale", "0 becomes hidden");
  } else if (scale != awayFromZero(scale)) {
    scale = awayFromZero(scale);
    report_.approximated("node '" + name + "', scale", "0 becomes 1e-9");
  }
  const double rotation[4] = {trs.rotation.x, trs.rotation.y, trs.rotation.z, trs.rotation.w};
  std::copy_n(rotation, 4, out.rotation);
  for (int i = 0; i < 3; ++i) out.translation[i] = trs.translation[i], out.scale[i] = scale[i];
}

std::vector<SceneWriter::Content> SceneWriter::contentsOf(std::size_t index, const std::string& name) {
  const tinygltf::Node& node = document_.model.nodes[index];
  std::vector<Content> out = meshContents(index, name);
  if (node.camera >= 0)
    report_.attempt("camera of '" + name + "'", [&] {
      document_.demand(at("cameras", std::size_t(node.camera)));
      Content camera;
      readCamera(document_.model.cameras[std::size_t(node.camera)], camera);
      out.push_back(std::move(camera));
    });
  const auto lights = node.extensions.find("KHR_lights_punctual");
  if (lights != node.extensions.end() && lights->second.IsObject() && lights->second.Has("light"))
    report_.attempt("light of '" + name + "'", [&] {
      const auto light = std::size_t(lights->second.Get("light").GetNumberAsInt());
      document_.demand(at("extensions.KHR_lights_punctual.lights", light));
      Content content;
      readLight(document_.model.lights.at(light), name, content);
      out.push_back(std::move(content));
    });
  return out;
}

/// One content is the node's object itself; of several, each is a child.
void SceneWriter::addObjects(sdk::ObjectRecord& object, const std::string& name, Json kept,
                             std::vector<Content> contents) {
  if (contents.size() != 1) {
    Content group;
    group.kept = std::move(kept);
    push(object, name, group);
    for (Content& content : contents) {
      content.record.id = nextId_++;
      content.record.parent = object.id;
      push(content.record, content.name.empty() ? name : content.name, content);
    }
    return;
  }
  Content& whole = contents[0];
  sdk::ObjectRecord& record = whole.record;
  record.id = object.id, record.parent = object.parent, record.visible = object.visible;
  std::copy_n(object.translation, 3, record.translation);
  std::copy_n(object.rotation, 4, record.rotation);
  std::copy_n(object.scale, 3, record.scale);
  kept.update(whole.kept);
  whole.kept = std::move(kept);
  push(record, name, whole);
}

void SceneWriter::push(sdk::ObjectRecord record, const std::string& name, const Content& content) {
  const std::string extras = extrasText(content.kept);
  record.name = name;
  record.extras = extras;
  record.imageFile = content.imageFile;
  sink_.addObject(record);
}

}  // namespace gltf
