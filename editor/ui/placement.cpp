// SPDX-License-Identifier: MIT
// Sizes and placements of new objects.
#include "editor/ui/placement.hpp"

#include <glm/gtc/quaternion.hpp>

#include <cmath>

#include "editor/photometry.hpp"

namespace steradian::ui {

namespace {

/// The nearest of ... 0.1, 0.2, 0.5, 1, 2, 5 ...: sizes that people would type.
double roundSize(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  const double lead = value / decade;
  return decade * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

/// Resizes a shape and says how far its centre must be from the surface with this normal to rest on it
/// upright.
struct Fit {
  double size;        // radius-like, metres
  glm::dvec3 normal;  // unit
  double operator()(Sphere& s) const { return s.radius = size; }
  double operator()(Plane&) const { return 0.0; }
  double operator()(MeshShape&) const { return 0.0; }
  double operator()(Box& b) const {
    b.size = glm::dvec3(2.0 * size);
    return size * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
  }
  double operator()(Rect& r) const {
    r.size = glm::dvec2(2.0 * size);
    return 0.01 * size;  // two surfaces in one place would fight
  }
  double operator()(Disk& d) const {
    d.radius = size;
    return 0.01 * size;
  }
  double operator()(Cylinder& c) const {
    c.radius = 0.7 * size;
    c.height = 2.0 * size;
    return size * std::abs(normal.y) + c.radius * std::hypot(normal.x, normal.z);
  }
};

bool isFlat(const Shape& shape) {
  return !std::holds_alternative<Sphere>(shape) && !std::holds_alternative<Box>(shape) &&
         !std::holds_alternative<Cylinder>(shape);
}

glm::dquat rotationFromTo(const glm::dvec3& from, const glm::dvec3& to) {
  const double cosine = glm::dot(from, to);
  if (cosine < -0.999999) return glm::angleAxis(3.14159265358979323846, glm::dvec3(1, 0, 0));
  const glm::dvec3 axis = glm::cross(from, to);
  return glm::normalize(glm::dquat(1.0 + cosine, axis.x, axis.y, axis.z));
}

edits::Added placedGeometry(const Scene& scene, Geometry geometry, const Place& place) {
  const double size = roundSize(0.12 * place.distance);
  Transform transform;
  const double lift = std::visit(Fit{size, place.normal}, geometry.shape);
  transform.translation = place.position + lift * place.normal;
  // Flat things lie on the surface, bodies stand upright.
  if (isFlat(geometry.shape)) transform.rotation = rotationFromTo({0, 1, 0}, place.normal);
  edits::Added material = edits::addMaterial(scene, Material{.name = edits::kindName(geometry)});
  return edits::addShape(std::move(material.scene), geometry.shape, transform, material.id);
}

/// Resizes a lamp that has a size.
struct FitLight {
  double size;  // radius-like, metres
  void operator()(SphereLight& l) const { l.radius = size; }
  void operator()(RectLight& l) const { l.size = glm::dvec2(2.0 * size); }
  void operator()(DiskLight& l) const { l.radius = size; }
  template <class WithoutSize>
  void operator()(WithoutSize&) const {}
};

edits::Added placedLight(const Scene& scene, Light light, const Place& place) {
  const double height = 0.35 * place.distance;
  Transform transform;
  transform.translation = place.position + height * place.normal;
  if (std::holds_alternative<EnvironmentLight>(light.kind)) return edits::addLight(scene, light, transform);
  if (std::holds_alternative<DirectionalLight>(light.kind)) {
    transform.rotation = rotationFromTo({0, 0, -1}, glm::normalize(glm::dvec3(-0.5, -1.0, -0.6)));
    return edits::addLight(scene, light, transform);
  }
  if (!std::holds_alternative<PointLight>(light.kind))
    transform.rotation = rotationFromTo({0, 0, -1}, -place.normal);
  std::visit(FitLight{roundSize(0.06 * place.distance)}, light.kind);
  // The same light on the surface below at any scale of the scene and for any size of the lamp
  light.intensity = 1.0f;
  const double perUnit = intensityAhead(light, glm::dmat4(1.0)).value_or(1.0);
  light.intensity = float(roundSize(std::max(100.0 * height * height / perUnit, 1e-6)));
  return edits::addLight(scene, light, transform);
}

edits::Added placedCamera(const Scene& scene, const CameraView& view) {
  Transform transform;
  transform.translation = glm::dvec3(view.worldFromCamera[3]);
  transform.rotation = glm::normalize(glm::quat_cast(glm::dmat3(view.worldFromCamera)));
  return edits::addCamera(scene, steradian::Camera{view.fovY}, transform);
}

}  // namespace

edits::Added placed(const Scene& scene, const edits::Content& content, const Place& place,
                    const CameraView& view) {
  if (const auto* geometry = std::get_if<Geometry>(&content)) return placedGeometry(scene, *geometry, place);
  if (const auto* light = std::get_if<Light>(&content)) return placedLight(scene, *light, place);
  if (std::holds_alternative<steradian::Camera>(content)) return placedCamera(scene, view);
  return edits::addGroup(scene, Transform{.translation = place.position});
}

Scene startScene() {
  Scene scene;
  scene.name = "Untitled";
  edits::Added ground =
      edits::addMaterial(scene, Material{.name = "Ground", .albedo = glm::vec3(0.5f), .roughness = 0.8f});
  scene = edits::addShape(std::move(ground.scene), Plane{}, {}, ground.id).scene;
  edits::Added clay = edits::addMaterial(
      scene, Material{.name = "Clay", .albedo = {0.72f, 0.32f, 0.18f}, .roughness = 0.35f});
  scene = edits::addShape(std::move(clay.scene), Sphere{}, {.translation = {0, 1, 0}}, clay.id).scene;
  scene = edits::addLight(scene, Light{.intensity = 150.0f}, {.translation = {2.5, 4.0, 2.0}}).scene;
  const Transform eye{.translation = {0.0, 2.0, 6.0}, .rotation = glm::angleAxis(-0.16, glm::dvec3(1, 0, 0))};
  return edits::addCamera(scene, steradian::Camera{}, eye).scene;
}

}  // namespace steradian::ui
