// SPDX-License-Identifier: MIT
// The rules of a sound scene, each with a message that says where, what and what was expected.
#include "renderer/scene/validate.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "renderer/scene/validate_detail.hpp"

namespace steradian {

std::string place(const Object& object) {
  return "object '" +
         (object.name.empty() ? std::string("#") + std::to_string(unsigned(object.id)) : object.name) + "'";
}
std::string place(const Material& material) {
  return "material '" +
         (material.name.empty() ? std::string("#") + std::to_string(unsigned(material.id)) : material.name) +
         "'";
}

namespace {

void checkScale(Checker& check, const std::string& field, const glm::dvec3& scale) {
  for (int i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    if (scale[i] == 0.0)
      check.fail(field, "is 0 along " + axis + "; expected a finite factor that is not 0");
    else
      check.range(field + "." + axis, std::abs(scale[i]), kSmallest, kLargest);
  }
}

void checkRotation(Checker& check, const std::string& field, const glm::dquat& rotation) {
  const double length = glm::length(rotation);
  if (!(std::abs(length - 1.0) <= 1e-6))
    check.fail(field, "has length " + text(length) + "; expected a unit quaternion");
}

void checkTransform(Checker& check, const Transform& transform) {
  check.each("transform.translation", transform.translation, -kLargest, kLargest);
  checkRotation(check, "transform.rotation", transform.rotation);
  checkScale(check, "transform.scale", transform.scale);
}

void checkIds(Checker& check, const Scene& scene) {
  std::unordered_set<Id> used;
  const auto claim = [&](Id id) {
    if (id == Id::none)
      check.fail("id", "is 0; expected a positive number");
    else if (!used.insert(id).second)
      check.fail(
          "id", "is " + std::to_string(unsigned(id)) + ", which is in use already; expected a unique number");
    else if (id >= scene.nextId)
      check.fail("id", "is " + std::to_string(unsigned(id)) + "; expected less than the scene's nextId, " +
                           std::to_string(unsigned(scene.nextId)));
  };
  for (const Object& object : scene.objects) check.at(place(object)), claim(object.id);
  for (const Material& material : scene.materials) check.at(place(material)), claim(material.id);
}

/// One problem per cycle and per missing parent; linear in the number of objects, without recursion.
void checkHierarchy(Checker& check, const Scene& scene) {
  std::unordered_map<Id, const Object*> byId;
  for (const Object& object : scene.objects) byId.emplace(object.id, &object);
  std::unordered_map<Id, const Object*> visitedFrom;  // which climb reached an object first
  for (const Object& start : scene.objects) {
    for (const Object* object = &start; object;) {
      const auto [visit, first] = visitedFrom.emplace(object->id, &start);
      if (!first) {
        check.at(place(*object));
        if (visit->second == &start)
          check.fail("parent", "makes a cycle; expected an object that is not inside this one");
        break;
      }
      if (object->parent == Id::none) break;
      const auto parent = byId.find(object->parent);
      if (parent == byId.end()) {
        check.at(place(*object));
        check.fail("parent", "is " + std::to_string(unsigned(object->parent)) + "; there is no such object");
        break;
      }
      object = parent->second;
    }
  }
}

/// Sound factors may still multiply to infinity or to nothing down a deep chain.
void checkWorldTransforms(Checker& check, const Scene& scene) {
  const std::vector<glm::dmat4> world = worldTransforms(scene);
  for (std::size_t i = 0; i < world.size(); ++i) {
    const glm::dmat3 linear(world[i]);
    const double size = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    const double offset = glm::length(glm::dvec3(world[i][3]));
    if (std::isfinite(size) && size >= 1e-18 && size <= 1e18 && offset <= 1e18) continue;
    check.at(place(scene.objects[i]));
    check.fail("transform", "with its parents' places the object out of range (size " + text(size) +
                                ", distance " + text(offset) +
                                "); expected sizes from 1e-18 to 1e18 and distances to 1e18");
    return;  // everything below it is out of range too
  }
}

void checkKeys(Checker& check, const Channel& channel) {
  if (channel.keys.empty()) check.fail("keys", "is empty; expected at least one key");
  for (std::size_t i = 0; i < channel.keys.size(); ++i) {
    const Keyframe& key = channel.keys[i];
    const std::string field = "keys[" + std::to_string(i) + "]";
    check.finite(field + ".time", key.time);
    if (i > 0 && !(key.time > channel.keys[i - 1].time))
      check.fail(field + ".time", "is " + text(key.time) + "; expected later than the key before, " +
                                      text(channel.keys[i - 1].time));
    check.each(field + ".value", key.value, -kLargest, kLargest);
    const glm::dvec4& v = key.value;
    if (channel.property == Property::rotation)
      checkRotation(check, field + ".value", glm::dquat(v.w, v.x, v.y, v.z));
    if (channel.property == Property::scale) checkScale(check, field + ".value", glm::dvec3(v));
    if (channel.property == Property::lightIntensity) check.range(field + ".value.x", v.x, 0.0, kBrightest);
    if (channel.property == Property::lightColor)
      check.each(field + ".value", glm::dvec3(v), 0.0, kBrightest);
  }
}

void checkAnimation(Checker& check, const Scene& scene) {
  check.at("animation");
  check.inside("framesPerSecond", scene.animation.framesPerSecond, 0.0, 1e6);
  std::unordered_map<Id, const Object*> byId;
  for (const Object& object : scene.objects) byId.emplace(object.id, &object);
  for (std::size_t i = 0; i < scene.animation.channels.size(); ++i) {
    const Channel& channel = scene.animation.channels[i];
    check.at("animation.channels[" + std::to_string(i) + "]");
    const auto target = byId.find(channel.target);
    const bool ofLight =
        channel.property == Property::lightIntensity || channel.property == Property::lightColor;
    if (target == byId.end())
      check.fail("target", "is " + std::to_string(unsigned(channel.target)) + "; there is no such object");
    else if (ofLight && !std::holds_alternative<Light>(target->second->content))
      check.fail("target", "is " + place(*target->second) + "; expected a light");
    checkKeys(check, channel);
  }
}

void checkSettings(Checker& check, const Scene& scene) {
  check.at("render");
  check.range("width", scene.render.width, 1, 16384);
  check.range("height", scene.render.height, 1, 16384);
  check.range("maxBounces", scene.render.maxBounces, 0, 64);
  check.range("lightSamples", scene.render.lightSamples, 1, 16);
  check.range("clamp", scene.render.clamp, 0.0, kBrightest);
  check.at("display");
  check.range("exposure", scene.display.exposure, -100.0, 100.0);
  // Moonless night -6, sunlit snow 16; with the stops the factor stays within float.
  check.range("ev100", scene.display.ev100, -25.0, 25.0);
  check.range("gamma", scene.display.gamma, 0.1, 10.0);
  for (const auto& [id, value] : scene.display.parameters) check.finite("parameters." + id, value);
  check.at("");
  const Object* camera = find(scene, scene.activeCamera);
  if (scene.activeCamera != Id::none && (!camera || !std::holds_alternative<Camera>(camera->content)))
    check.fail("activeCamera",
               "is " + std::to_string(unsigned(scene.activeCamera)) + "; expected the id of a camera");
}

}  // namespace

std::vector<Problem> problemsOf(const Scene& scene) {
  std::vector<Problem> problems;
  Checker check(problems);
  std::unordered_set<Id> materials;
  for (const Material& material : scene.materials) materials.insert(material.id);
  checkIds(check, scene);
  for (const Object& object : scene.objects) {
    check.at(place(object));
    checkTransform(check, object.transform);
    checkContent(check, object, materials);
  }
  for (const Material& material : scene.materials) checkMaterial(check, material);
  checkHierarchy(check, scene);
  if (problems.empty()) checkWorldTransforms(check, scene);
  checkAnimation(check, scene);
  checkSettings(check, scene);
  return problems;
}

}  // namespace steradian
