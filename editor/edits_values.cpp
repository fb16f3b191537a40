// SPDX-License-Identifier: MIT
// Edits of values: contents, materials, settings, keyframes.
#include <algorithm>
#include <optional>
#include <unordered_set>

#include "editor/edits.hpp"
#include "editor/edits_detail.hpp"

namespace steradian::edits {

namespace {

std::string freeMaterialName(const Scene& scene, std::string_view wanted, Id except) {
  std::unordered_set<std::string_view> taken;
  for (const Material& material : scene.materials)
    if (material.id != except) taken.insert(material.name);
  return freeName(wanted.empty() ? "Material" : wanted, taken);
}

bool isLightProperty(Property property) {
  return property == Property::lightIntensity || property == Property::lightColor;
}

void eraseChannels(Scene& scene, Id object, bool (*which)(Property)) {
  std::erase_if(scene.animation.channels,
                [&](const Channel& channel) { return channel.target == object && which(channel.property); });
}

/// The present value in the layout of Keyframe::value; nullopt when the object has no such property.
std::optional<glm::dvec4> presentValue(const Object& object, Property property) {
  const Light* light = std::get_if<Light>(&object.content);
  if (isLightProperty(property) && !light) return std::nullopt;
  const glm::dquat& q = object.transform.rotation;
  switch (property) {
    case Property::translation:
      return glm::dvec4(object.transform.translation, 0.0);
    case Property::rotation:
      return glm::dvec4(q.x, q.y, q.z, q.w);
    case Property::scale:
      return glm::dvec4(object.transform.scale, 0.0);
    case Property::lightIntensity:
      return glm::dvec4(light->intensity, 0.0, 0.0, 0.0);
    case Property::lightColor:
      return glm::dvec4(glm::dvec3(light->color), 0.0);
  }
  return std::nullopt;
}

Channel* channelOf(Scene& scene, Id object, Property property) {
  const auto found = std::find_if(
      scene.animation.channels.begin(), scene.animation.channels.end(),
      [&](const Channel& channel) { return channel.target == object && channel.property == property; });
  return found == scene.animation.channels.end() ? nullptr : &*found;
}

std::vector<Keyframe>::iterator firstKeyFrom(std::vector<Keyframe>& keys, double time) {
  return std::lower_bound(keys.begin(), keys.end(), time,
                          [](const Keyframe& key, double t) { return key.time < t; });
}

}  // namespace

Scene setContent(Scene scene, Id object, const Content& content) {
  Object* found = findMutable(scene, object);
  if (!found) return scene;
  found->content = content;
  if (!std::holds_alternative<Light>(content)) eraseChannels(scene, object, isLightProperty);
  if (scene.activeCamera == object && !std::holds_alternative<Camera>(content)) scene.activeCamera = Id::none;
  return scene;
}

Added addMaterial(Scene scene, Material material) {
  material.name = freeMaterialName(scene, material.name, Id::none);
  material.id = takeId(scene);
  scene.materials.push_back(material);
  return {std::move(scene), material.id};
}

Scene setMaterial(Scene scene, const Material& material) {
  const std::string name = freeMaterialName(scene, material.name, material.id);
  for (Material& existing : scene.materials) {
    if (existing.id != material.id) continue;
    existing = material;
    existing.name = name;
  }
  return scene;
}

Scene assignMaterial(Scene scene, std::span<const Id> objects, Id material) {
  for (const Id id : objects) {
    Object* object = findMutable(scene, id);
    if (!object) continue;
    if (auto* geometry = std::get_if<Geometry>(&object->content)) geometry->material = material;
  }
  return scene;
}

Added assignNewMaterial(Scene scene, Id object) {
  const Object* found = find(scene, object);
  const auto* geometry = found ? std::get_if<Geometry>(&found->content) : nullptr;
  if (!geometry) return {std::move(scene), Id::none};
  const Material* present = findMaterial(scene, geometry->material);
  Added added = addMaterial(std::move(scene), present ? Material(*present) : Material{});
  const Id objects[] = {object};
  added.scene = assignMaterial(std::move(added.scene), objects, added.id);
  return added;
}

Scene removeUnusedMaterials(Scene scene) {
  std::unordered_set<Id> used;
  for (const Object& object : scene.objects)
    if (const auto* geometry = std::get_if<Geometry>(&object.content)) used.insert(geometry->material);
  std::erase_if(scene.materials, [&](const Material& material) { return used.count(material.id) == 0; });
  return scene;
}

Scene setRender(Scene scene, const RenderSettings& render) {
  scene.render = render;
  return scene;
}

Scene setDisplay(Scene scene, const DisplaySettings& display) {
  scene.display = display;
  return scene;
}

Scene setActiveCamera(Scene scene, Id camera) {
  const Object* object = find(scene, camera);
  if (object && std::holds_alternative<Camera>(object->content)) scene.activeCamera = camera;
  return scene;
}

Scene setKeyframe(Scene scene, Id object, Property property, double time) {
  const Object* found = find(scene, object);
  const auto value = found ? presentValue(*found, property) : std::nullopt;
  if (!value) return scene;
  if (!channelOf(scene, object, property))
    scene.animation.channels.push_back({object, property, Interpolation::linear, {}});
  std::vector<Keyframe>& keys = channelOf(scene, object, property)->keys;
  const auto key = firstKeyFrom(keys, time);
  if (key != keys.end() && key->time == time)
    key->value = *value;
  else
    keys.insert(key, {time, *value});
  return scene;
}

Scene removeKeyframe(Scene scene, Id object, Property property, double time) {
  Channel* channel = channelOf(scene, object, property);
  if (!channel) return scene;
  std::erase_if(channel->keys, [&](const Keyframe& key) { return key.time == time; });
  std::erase_if(scene.animation.channels, [](const Channel& c) { return c.keys.empty(); });
  return scene;
}

}  // namespace steradian::edits
