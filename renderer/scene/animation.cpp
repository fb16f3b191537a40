// SPDX-License-Identifier: MIT
// Evaluates keyed animation: step, linear and Catmull-Rom; rotations by slerp.
#include "renderer/scene/animation.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "renderer/scene/scene.hpp"

namespace steradian {

namespace {

glm::dquat rotationOf(const glm::dvec4& value) {
  return glm::dquat(value.w, value.x, value.y, value.z);
}

glm::dvec4 slerped(const glm::dvec4& a, const glm::dvec4& b, double u) {
  const glm::dquat q = glm::normalize(glm::slerp(rotationOf(a), rotationOf(b), u));
  return {q.x, q.y, q.z, q.w};
}

/// Tangent at key i for keys at uneven times: the slope between its neighbours (Catmull and Rom 1974).
glm::dvec4 tangent(const std::vector<Keyframe>& keys, std::size_t i) {
  const Keyframe& before = keys[i == 0 ? 0 : i - 1];
  const Keyframe& after = keys[std::min(i + 1, keys.size() - 1)];
  return (after.value - before.value) / (after.time - before.time);
}

/// Cubic Hermite segment from key i to i + 1, u in [0, 1].
glm::dvec4 hermite(const std::vector<Keyframe>& keys, std::size_t i, double u) {
  const double span = keys[i + 1].time - keys[i].time, u2 = u * u, u3 = u2 * u;
  return (2.0 * u3 - 3.0 * u2 + 1.0) * keys[i].value + (u3 - 2.0 * u2 + u) * span * tangent(keys, i) +
         (3.0 * u2 - 2.0 * u3) * keys[i + 1].value + (u3 - u2) * span * tangent(keys, i + 1);
}

glm::dvec4 valueAt(const Channel& channel, double time) {
  const std::vector<Keyframe>& keys = channel.keys;
  if (!(time > keys.front().time)) return keys.front().value;
  if (time >= keys.back().time) return keys.back().value;
  const auto next = std::upper_bound(keys.begin(), keys.end(), time,
                                     [](double t, const Keyframe& key) { return t < key.time; });
  const std::size_t i = std::size_t(next - keys.begin()) - 1;
  const double u = (time - keys[i].time) / (keys[i + 1].time - keys[i].time);
  if (channel.interpolation == Interpolation::step) return keys[i].value;
  if (channel.property == Property::rotation) return slerped(keys[i].value, keys[i + 1].value, u);
  if (channel.interpolation == Interpolation::cubic) return hermite(keys, i, u);
  return glm::mix(keys[i].value, keys[i + 1].value, u);
}

/// Keys on both sides of 0 pass through it; a flat object has no inverse, so it stays just short of flat.
double awayFromZero(double scale) {
  constexpr double kFlattest = 1e-9;
  return std::abs(scale) < kFlattest ? std::copysign(kFlattest, scale) : scale;
}

void apply(Object& object, Property property, const glm::dvec4& value) {
  Light* light = std::get_if<Light>(&object.content);
  switch (property) {
    case Property::translation:
      object.transform.translation = glm::dvec3(value);
      break;
    case Property::rotation:
      object.transform.rotation = glm::normalize(rotationOf(value));
      break;
    case Property::scale:
      object.transform.scale = {awayFromZero(value.x), awayFromZero(value.y), awayFromZero(value.z)};
      break;
    // A cubic overshoots its keys; light is never negative.
    case Property::lightIntensity:
      if (light) light->intensity = std::max(0.0f, float(value.x));
      break;
    case Property::lightColor:
      if (light) light->color = glm::max(glm::vec3(0.0f), glm::vec3(value));
      break;
  }
}

}  // namespace

Scene evaluatedAt(const Scene& scene, double timeSeconds) {
  Scene evaluated = scene;
  if (scene.animation.channels.empty()) return evaluated;
  std::unordered_map<Id, Object*> objects;
  for (Object& object : evaluated.objects) objects.emplace(object.id, &object);
  for (const Channel& channel : scene.animation.channels) {
    const auto target = objects.find(channel.target);
    if (target == objects.end() || channel.keys.empty()) continue;
    apply(*target->second, channel.property, valueAt(channel, timeSeconds));
  }
  return evaluated;
}

}  // namespace steradian
