// SPDX-License-Identifier: MIT
// A Scene as an exporter reads it.
#include "plugins/host/scene_records.hpp"

namespace steradian::plugins {

namespace {

template <class Vector, class Number, std::size_t N>
void copy(const Vector& from, Number (&to)[N]) {
  for (std::size_t i = 0; i < N && i < std::size_t(Vector::length()); ++i) to[i] = from[int(i)];
}

struct ShapeRecorder {
  sdk::ObjectRecord& out;
  const HeavyRecords& heavy;
  void operator()(const MeshShape& s) const {
    out.kind = sdk::ObjectKind::mesh, out.mesh = heavy.idOf(s.mesh.get());
  }
  void operator()(const Sphere& s) const { out.kind = sdk::ObjectKind::sphere, out.radius = s.radius; }
  void operator()(const Plane&) const { out.kind = sdk::ObjectKind::plane; }
  void operator()(const Box& s) const { out.kind = sdk::ObjectKind::box, copy(s.size, out.dimensions); }
  void operator()(const Rect& s) const { out.kind = sdk::ObjectKind::rect, copy(s.size, out.dimensions); }
  void operator()(const Disk& s) const { out.kind = sdk::ObjectKind::disk, out.radius = s.radius; }
  void operator()(const Cylinder& s) const {
    out.kind = sdk::ObjectKind::cylinder, out.radius = s.radius, out.height = s.height;
  }
};

struct LightRecorder {
  sdk::ObjectRecord& out;
  void operator()(const PointLight&) const { out.kind = sdk::ObjectKind::pointLight; }
  void operator()(const SpotLight& spot) const {
    out.kind = sdk::ObjectKind::spotLight;
    out.innerConeAngle = spot.innerConeAngle;
    out.outerConeAngle = spot.outerConeAngle;
  }
  void operator()(const DirectionalLight& sun) const {
    out.kind = sdk::ObjectKind::directionalLight, out.angularDiameter = sun.angularDiameter;
  }
  void operator()(const SphereLight& l) const {
    out.kind = sdk::ObjectKind::sphereLight, out.radius = l.radius;
  }
  void operator()(const RectLight& l) const {
    out.kind = sdk::ObjectKind::rectLight, copy(l.size, out.dimensions);
  }
  void operator()(const DiskLight& l) const { out.kind = sdk::ObjectKind::diskLight, out.radius = l.radius; }
  void operator()(const EnvironmentLight& sky) const {
    out.kind = sdk::ObjectKind::environmentLight;
    copy(sky.horizon, out.horizon);
    copy(sky.ground, out.ground);
    out.imageFile = sky.file;
  }
};

struct ContentRecorder {
  sdk::ObjectRecord& out;
  const HeavyRecords& heavy;
  void operator()(const Group&) const { out.kind = sdk::ObjectKind::group; }
  void operator()(const Geometry& g) const {
    std::visit(ShapeRecorder{out, heavy}, g.shape);
    out.material = std::uint32_t(g.material);
  }
  void operator()(const Camera& c) const {
    out.kind = sdk::ObjectKind::camera, out.fovY = c.fovY;
    out.projection = std::uint32_t(c.projection);
    out.orthographicHeight = c.orthographicHeight;
    out.fNumber = c.fNumber;
    out.focusDistance = c.focusDistance;
  }
  void operator()(const Light& light) const {
    copy(light.color, out.color);
    out.intensity = light.intensity;
    out.temperature = light.temperature;
    std::visit(LightRecorder{out}, light.kind);
  }
};

sdk::ObjectRecord recordOf(const Object& object, const HeavyRecords& heavy) {
  sdk::ObjectRecord out;
  out.id = std::uint32_t(object.id);
  out.parent = std::uint32_t(object.parent);
  out.visible = object.visible;
  out.name = object.name;
  out.extras = object.extras;
  const Transform& t = object.transform;
  copy(t.translation, out.translation);
  copy(glm::dvec4(t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w), out.rotation);
  copy(t.scale, out.scale);
  std::visit(ContentRecorder{out, heavy}, object.content);
  return out;
}

sdk::MaterialRecord recordOf(const Material& material, const HeavyRecords& heavy) {
  sdk::MaterialRecord out;
  out.id = std::uint32_t(material.id);
  out.name = material.name;
  out.extras = material.extras;
  copy(material.albedo, out.albedo);
  out.metallic = material.metallic;
  out.roughness = material.roughness;
  out.specular = material.specular;
  out.ior = material.ior;
  copy(material.emissionColor, out.emissionColor);
  out.emissionLuminance = material.emissionLuminance;
  out.transmission = material.transmission;
  copy(material.attenuationColor, out.attenuationColor);
  out.attenuationDistance = material.attenuationDistance;
  out.clearcoat = material.clearcoat;
  out.clearcoatRoughness = material.clearcoatRoughness;
  copy(material.edgeTint, out.edgeTint);
  out.albedoTexture = heavy.slot(material.albedoTexture);
  out.metallicRoughnessTexture = heavy.slot(material.metallicRoughnessTexture);
  out.normalTexture = heavy.slot(material.normalTexture);
  out.emissionTexture = heavy.slot(material.emissionTexture);
  out.normalScale = material.normalScale;
  out.opacity = material.opacity;
  out.alphaMode = std::uint32_t(material.alphaMode);
  out.alphaCutoff = material.alphaCutoff;
  out.thinWalled = material.thinWalled;
  return out;
}

sdk::RenderSettingsRecord recordOf(const RenderSettings& s) {
  return {.width = s.width,
          .height = s.height,
          .maxBounces = s.maxBounces,
          .lightSamples = s.lightSamples,
          .russianRoulette = s.russianRoulette,
          .errorMeter = s.errorMeter,
          .filter = std::uint32_t(s.filter),
          .seed = s.seed,
          .energyCompensation = s.energyCompensation,
          .clamp = s.clamp};
}

}  // namespace

SceneRecords::SceneRecords(const Scene& scene) : heavy_(scene), render_(recordOf(scene.render)) {
  scene_.activeCamera = std::uint32_t(scene.activeCamera);
  scene_.nextId = std::uint32_t(scene.nextId);
  scene_.framesPerSecond = scene.animation.framesPerSecond;
  scene_.name = scene.name;
  scene_.extras = scene.extras;
  for (const auto& [id, value] : scene.display.parameters) parameters_.push_back({id, value});
  display_.exposure = scene.display.exposure;
  display_.tonemapper = scene.display.tonemapper;
  display_.transfer = std::uint32_t(scene.display.transfer);
  display_.gamma = scene.display.gamma;
  display_.physical = scene.display.physical;
  display_.ev100 = scene.display.ev100;
  display_.parameters = parameters_.data();
  display_.parameterCount = parameters_.size();
  for (const Material& material : scene.materials) materials_.push_back(recordOf(material, heavy_));
  for (const Object& object : scene.objects) objects_.push_back(recordOf(object, heavy_));
  keys_.reserve(scene.animation.channels.size());
  for (const Channel& channel : scene.animation.channels) addChannel(channel);
}

void SceneRecords::addChannel(const Channel& channel) {
  auto& keys = keys_.emplace_back();
  for (const Keyframe& key : channel.keys) {
    keys.push_back({.time = key.time});
    copy(key.value, keys.back().value);
  }
  channels_.push_back({.target = std::uint32_t(channel.target),
                       .property = std::uint32_t(channel.property),
                       .interpolation = std::uint32_t(channel.interpolation),
                       .keys = keys.data(),
                       .keyCount = keys.size()});
}

}  // namespace steradian::plugins
