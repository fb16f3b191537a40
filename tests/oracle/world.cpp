// SPDX-License-Identifier: MIT
#include "tests/oracle/world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/oracle/blackbody.hpp"

namespace steradian::oracle {
namespace {

/// From the frame of a flat shape (in XZ, normal +Y) to that of a light (in XY, shining along -Z).
const dmat4 kLightFromFlat(dmat3(dvec3(1, 0, 0), dvec3(0, 0, -1), dvec3(0, 1, 0)));

dmat3 rotationOf(const dmat4& m) {
  return glm::mat3_cast(transformOf(m).rotation);
}

Body glowing(const Shape& shape, const dmat4& worldFromShape, const dvec3& nit, bool oneSided) {
  return {shape, glm::inverse(worldFromShape), nullptr, nit, oneSided};
}

dvec3 nearestTexel(const Image& image, const dvec3& d) {
  const double u = 0.5 + std::atan2(d.x, -d.z) / (2.0 * std::numbers::pi);
  const double v = std::acos(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi;
  const int x = std::clamp(int(u * image.width), 0, image.width - 1);
  const int y = std::clamp(int(v * image.height), 0, image.height - 1);
  const float* texel = image.at(x, y);
  return {texel[0], texel[1], texel[2]};
}

}  // namespace

bool Body::solid() const {
  if (std::holds_alternative<MeshShape>(shape)) return finish && !finish->material.thinWalled;
  return !std::holds_alternative<Rect>(shape) && !std::holds_alternative<Disk>(shape);
}

dvec3 Sky::radiance(const dvec3& direction) const {
  const dvec3 d = localFromWorld * direction;
  const dvec3 end = d.y > 0.0 ? dvec3(1.0) : dvec3(light.ground);
  const dvec3 gradient = glm::mix(dvec3(light.horizon), end, std::abs(d.y));
  return scale * gradient * (light.image ? nearestTexel(*light.image, d) : dvec3(1.0));
}

dvec3 World::background(const dvec3& direction) const {
  dvec3 L = sky ? sky->radiance(direction) : dvec3(0.0);
  for (const SunDisc& sun : suns)
    if (glm::dot(direction, sun.towards) > sun.cosHalf) L += sun.radiance;
  return L;
}

World::World(const Scene& scene) : compensate(scene.render.energyCompensation) {
  const auto placed = worldTransforms(scene);
  const auto visible = hierarchyVisibility(scene);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (!visible[i]) continue;
    if (const auto* geometry = std::get_if<Geometry>(&scene.objects[i].content)) {
      const Finish* finish = finishOf(scene, geometry->material);
      const Material& m = finish->material;
      bodies.push_back({geometry->shape, glm::inverse(placed[i]), finish,
                        dvec3(m.emissionColor) * double(m.emissionLuminance), false});
    } else if (const auto* light = std::get_if<Light>(&scene.objects[i].content)) {
      add(*light, placed[i]);
    }
  }
}

const Finish* World::finishOf(const Scene& scene, Id id) {
  const auto [place, isNew] = finishes.try_emplace(id);
  Finish& finish = place->second;
  if (!isNew) return &finish;
  if (const Material* m = findMaterial(scene, id)) finish.material = *m;
  const Material& m = finish.material;
  const auto alpha = [](float roughness) { return double(roughness) * roughness; };
  if (compensate) {
    finish.base = std::make_shared<AlbedoTable>(alpha(m.roughness), m.transmission > 0 ? m.ior : 1.0);
    if (m.clearcoat > 0) finish.coat = std::make_shared<AlbedoTable>(alpha(m.clearcoatRoughness), 1.0);
  }
  return &finish;
}

void World::add(const Light& light, const dmat4& worldFromObject) {
  const dvec3 glow = light.temperature > 0.0f ? blackbodyColor(light.temperature) : dvec3(1.0);
  const dvec3 scale = dvec3(light.color) * glow * double(light.intensity);
  const dmat3 rotation = rotationOf(worldFromObject);
  const dvec3 position(worldFromObject[3]), axis = -rotation[2];
  const dmat4 worldFromFlat = worldFromObject * kLightFromFlat;
  if (std::holds_alternative<PointLight>(light.kind)) punctual.push_back({position, axis, scale});
  if (const auto* spot = std::get_if<SpotLight>(&light.kind))
    punctual.push_back({position, axis, scale, false, std::cos(double(spot->innerConeAngle)),
                        std::cos(double(spot->outerConeAngle))});
  if (const auto* sun = std::get_if<DirectionalLight>(&light.kind)) {
    const double half = 0.5 * sun->angularDiameter;
    if (half > 0.0)
      suns.push_back({-axis, std::cos(half), scale / (std::numbers::pi * std::sin(half) * std::sin(half))});
    else
      punctual.push_back({position, axis, scale, true});
  }
  if (const auto* sphere = std::get_if<SphereLight>(&light.kind))
    bodies.push_back(glowing(Sphere{sphere->radius}, worldFromObject, scale, false));
  if (const auto* rect = std::get_if<RectLight>(&light.kind))
    bodies.push_back(glowing(Rect{rect->size}, worldFromFlat, scale, true));
  if (const auto* disk = std::get_if<DiskLight>(&light.kind))
    bodies.push_back(glowing(Disk{disk->radius}, worldFromFlat, scale, true));
  if (const auto* environment = std::get_if<EnvironmentLight>(&light.kind); environment && !sky)
    sky = std::make_unique<Sky>(Sky{glm::transpose(rotation), *environment, scale});
}

}  // namespace steradian::oracle
