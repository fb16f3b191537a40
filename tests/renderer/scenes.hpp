// SPDX-License-Identifier: MIT
// Short ways to build the scenes that the image tests render.
#pragma once
#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/scene/scene.hpp"

namespace steradian::scenes {

using glm::dvec3;
inline constexpr double pi = std::numbers::pi;

inline Material lambert(glm::vec3 albedo) {
  Material m;
  m.albedo = albedo;
  m.specular = 0.0f;
  return m;
}
inline Material emitter(float nit, glm::vec3 albedo = glm::vec3(0.0f)) {
  Material m = lambert(albedo);
  m.emissionLuminance = nit;
  return m;
}
inline Material metal(float roughness, glm::vec3 f0 = glm::vec3(1.0f)) {
  Material m;
  m.albedo = f0;
  m.metallic = 1.0f;
  m.roughness = roughness;
  return m;
}
inline Material plastic(float roughness, glm::vec3 albedo) {
  Material m;
  m.albedo = albedo;
  m.roughness = roughness;
  return m;
}

inline Id takeId(Scene& scene) {
  const Id id = scene.nextId;
  scene.nextId = Id{unsigned(id) + 1};
  return id;
}
inline Id add(Scene& scene, Material material) {
  material.id = takeId(scene);
  scene.materials.push_back(material);
  return material.id;
}
inline Transform at(const dvec3& translation, const dvec3& axis = {0.0, 1.0, 0.0}, double radians = 0.0,
                    const dvec3& scale = dvec3(1.0)) {
  return {translation, glm::angleAxis(radians, glm::normalize(axis)), scale};
}
inline Id add(Scene& scene, const Transform& place, Shape shape, Id material) {
  Object object;
  object.id = takeId(scene);
  object.transform = place;
  object.content = Geometry{shape, material};
  scene.objects.push_back(object);
  return object.id;
}
inline Id add(Scene& scene, const Transform& place, Shape shape, const Material& material) {
  return add(scene, place, shape, add(scene, material));
}
template <class Kind>
Id addLight(Scene& scene, const Transform& place, Kind kind, float intensity,
            glm::vec3 color = glm::vec3(1.0f)) {
  Object object;
  object.id = takeId(scene);
  object.transform = place;
  object.content = Light{kind, color, intensity};
  scene.objects.push_back(object);
  return object.id;
}

/// A light's or camera's rotation that turns -Z to `direction`.
inline glm::dquat facing(const dvec3& direction) {
  const dvec3 z = -glm::normalize(direction);
  const dvec3 helper = std::abs(z.y) < 0.9 ? dvec3(0.0, 1.0, 0.0) : dvec3(0.0, 0.0, 1.0);
  const dvec3 x = glm::normalize(glm::cross(helper, z));
  return glm::normalize(glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z)));
}
inline CameraView lookAt(const dvec3& eye, const dvec3& target, double fovY) {
  return {matrixOf({eye, facing(target - eye), dvec3(1.0)}), fovY};
}

/// Closed forms hold for a box filter, and for paths of a known number of bounces.
inline Scene plainScene(int maxBounces) {
  Scene scene;
  scene.render.maxBounces = maxBounces;
  scene.render.russianRoulette = false;
  scene.render.filter = PixelFilter::box;
  return scene;
}

inline void translate(Scene& scene, CameraView& view, const dvec3& offset) {
  for (Object& object : scene.objects)
    if (object.parent == Id::none) object.transform.translation += offset;
  view.worldFromCamera[3] += glm::dvec4(offset, 0.0);
}

/// A closed coloured room, 6 x 4 x 10 m around (0, 2, 1), with a lamp ball, a metal, a plastic and a matt
/// ball.
inline Scene room(int maxBounces) {
  Scene scene = plainScene(maxBounces);
  const Id white = add(scene, plastic(0.6f, glm::vec3(0.75f)));
  add(scene, at({0, 2, 1}), Box{{6, 4, 10}}, white);
  add(scene, at({0, 0.001, 1}), Plane{}, lambert({0.7f, 0.3f, 0.1f}));
  add(scene, at({-1.3, 1, -1.5}), Sphere{1.0}, metal(0.2f, {1.0f, 0.78f, 0.34f}));
  add(scene, at({1.2, 0.8, -0.8}), Sphere{0.8}, plastic(0.1f, {0.2f, 0.3f, 0.8f}));
  add(scene, at({0, 0.5, 0.6}), Sphere{0.5}, lambert(glm::vec3(0.9f)));
  add(scene, at({0, 3.2, 0}), Sphere{0.6}, emitter(5.0f, glm::vec3(0.5f)));
  addLight(scene, at({1.5, 3.4, 2}), PointLight{}, 3.0f);
  return scene;
}
inline CameraView roomView() {
  return lookAt({0, 2, 5.5}, {0, 1.5, 0}, 0.9);
}

}  // namespace steradian::scenes
