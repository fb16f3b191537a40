// SPDX-License-Identifier: MIT
// Scenes that Steradian exported: analytic shapes, area lights and keys come back as they were.
#include <algorithm>
#include <cmath>

#include "restore_fields.hpp"
#include "restore_settings.hpp"
#include "scene_writer.hpp"

namespace gltf {

std::vector<SceneWriter::Content> SceneWriter::restoredContents(std::size_t index, const std::string& name,
                                                                sdk::ObjectRecord& object) {
  const Json ours = oursOf(document_.model.nodes[index].extras_json_string);
  if (ours.empty()) return contentsOf(index, name);
  std::vector<Content> contents;
  if (!ours.contains("kind")) contents = contentsOf(index, name);
  const bool whole = contents.empty() && ours.contains("kind");
  if (whole) contents.emplace_back();
  const bool sound = report_.attempt("node '" + name + "'", [&] {
    const bool one = contents.size() == 1;
    OwnObject own = restoreObject(ours, one ? contents[0].record : object, document_.model.materials.size());
    if (ours.contains("visible")) object.visible = own.record.visible;
    if (!one) return;
    if (own.material) own.record.material = materials_.id(*own.material);
    contents[0].record = own.record;
    contents[0].imageFile = own.imageFile;
  });
  return sound || !whole ? contents : contentsOf(index, name);
}

void SceneWriter::addOwnChannels(std::vector<Track>& tracks, sdk::SceneRecord& scene) {
  const auto& model = document_.model;
  std::vector<Json> all;
  for (std::size_t a = 0; a < model.animations.size(); ++a)
    if (choices_.animation < 0 || choices_.animation == int(a))
      all.push_back(oursOf(model.animations[a].extras_json_string));
  if (shownScene() < model.scenes.size())
    all.push_back(oursOf(model.scenes[shownScene()].extras_json_string));
  for (const Json& ours : all)
    report_.attempt("animation", [&] {
      if (const Json rate = ours.value("framesPerSecond", Json()); rate.is_number() && rate > 0 && rate < 1e6)
        scene.framesPerSecond = rate;
      for (const OwnChannel& channel : restoreChannels(ours, model.nodes.size()))
        addOwnChannel(channel, tracks);
    });
}

/// Our keys replace the track that says the same in glTF's words.
void SceneWriter::addOwnChannel(const OwnChannel& channel, std::vector<Track>& tracks) {
  const sdk::ObjectKind kind = kindOf_[channel.node];
  const bool light = (kind >= sdk::ObjectKind::pointLight && kind <= sdk::ObjectKind::directionalLight) ||
                     (kind >= sdk::ObjectKind::sphereLight && kind <= sdk::ObjectKind::environmentLight);
  if (objectOf_[channel.node] == 0 || (channel.property > 2 && !light)) return;
  std::erase_if(tracks, [&](const Track& track) {
    return track.node == channel.node && std::uint32_t(track.path) == channel.property;
  });
  sink_.addChannel({.target = objectOf_[channel.node],
                    .property = channel.property,
                    .interpolation = channel.interpolation,
                    .keys = channel.keys.data(),
                    .keyCount = channel.keys.size()});
}

void SceneWriter::addActiveCamera(const Json& ours, sdk::SceneRecord& scene) {
  if (!ours.contains("activeCamera")) return;
  report_.attempt("scene", [&] {
    const double last = double(objectOf_.size()) - 1.0;
    const auto node = std::size_t(numberIn(ours["activeCamera"], "activeCamera", 0, last));
    if (kindOf_[node] == sdk::ObjectKind::camera) scene.activeCamera = objectOf_[node];
  });
}

/// glTF's cameras know the shape of the picture; all else is ours.
void SceneWriter::addSettings(const Json& ours) {
  sdk::RenderSettingsRecord render;
  if (aspectRatio_ != 0)
    render.width = int(std::clamp(std::round(render.height * aspectRatio_), 1.0, 16384.0));
  report_.attempt("scene, render settings",
                  [&] { render = restoreRender(ours.value("render", Json::object()), render); });
  sink_.setRender(render);
  if (!ours.contains("display")) return;
  report_.attempt("scene, display settings", [&] {
    OwnDisplay display;
    restoreDisplay(ours["display"], display);
    sink_.setDisplay(display.record);
  });
}

}  // namespace gltf
