// SPDX-License-Identifier: MIT
// The sink: collects what an importer pushes and makes a validated Scene of it, or nothing.
#include "plugins/host/scene_builder.hpp"

#include <algorithm>
#include <new>

#include "plugins/host/utf8.hpp"

namespace steradian::plugins {

namespace {

glm::dvec3 vec3Of(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}
glm::vec3 vec3Of(const float (&v)[3]) {
  return {v[0], v[1], v[2]};
}

Light lightOf(const sdk::ObjectRecord& r) {
  Light light{.color = vec3Of(r.color), .intensity = r.intensity};
  light.temperature = r.temperature;
  if (r.kind == sdk::ObjectKind::spotLight) light.kind = SpotLight{r.innerConeAngle, r.outerConeAngle};
  if (r.kind == sdk::ObjectKind::directionalLight) light.kind = DirectionalLight{r.angularDiameter};
  if (r.kind == sdk::ObjectKind::sphereLight) light.kind = SphereLight{r.radius};
  if (r.kind == sdk::ObjectKind::rectLight) light.kind = RectLight{{r.dimensions[0], r.dimensions[1]}};
  if (r.kind == sdk::ObjectKind::diskLight) light.kind = DiskLight{r.radius};
  if (r.kind == sdk::ObjectKind::environmentLight)
    light.kind =
        EnvironmentLight{.horizon = vec3Of(r.horizon), .ground = vec3Of(r.ground), .file = r.imageFile.str()};
  return light;
}

Camera cameraOf(const sdk::ObjectRecord& r) {
  return {.fovY = r.fovY,
          .projection = Projection{r.projection},
          .orthographicHeight = r.orthographicHeight,
          .fNumber = r.fNumber,
          .focusDistance = r.focusDistance};
}

/// False for a kind that this version does not know.
bool contentOf(const sdk::ObjectRecord& r, Object& out) {
  const auto shape = [&](Shape s) { out.content = Geometry{s, Id{r.material}}; };
  switch (r.kind) {
    case sdk::ObjectKind::group:
      out.content = Group{};
      return true;
    case sdk::ObjectKind::sphere:
      shape(Sphere{r.radius});
      return true;
    case sdk::ObjectKind::plane:
      shape(Plane{});
      return true;
    case sdk::ObjectKind::box:
      shape(Box{vec3Of(r.dimensions)});
      return true;
    case sdk::ObjectKind::rect:
      shape(Rect{{r.dimensions[0], r.dimensions[1]}});
      return true;
    case sdk::ObjectKind::disk:
      shape(Disk{r.radius});
      return true;
    case sdk::ObjectKind::cylinder:
      shape(Cylinder{r.radius, r.height});
      return true;
    case sdk::ObjectKind::mesh:
      shape(MeshShape{});  // linked when everything is there
      return true;
    case sdk::ObjectKind::pointLight:
    case sdk::ObjectKind::spotLight:
    case sdk::ObjectKind::directionalLight:
    case sdk::ObjectKind::sphereLight:
    case sdk::ObjectKind::rectLight:
    case sdk::ObjectKind::diskLight:
    case sdk::ObjectKind::environmentLight:
      out.content = lightOf(r);
      return true;
    case sdk::ObjectKind::camera:
      out.content = cameraOf(r);
      return true;
  }
  return false;
}

}  // namespace

template <class Work>
void SceneBuilder::keeping(Work&& work) noexcept try {
  work();
} catch (const std::exception&) {
  outOfMemory_ = true;  // copying plain data fails for no other reason
}

std::string SceneBuilder::textOf(const sdk::Text& text, const std::string& where) {
  if (!isUtf8(text.view())) {
    problems_.push_back({where, "is not valid UTF-8"});
    return {};
  }
  return text.str();
}

void SceneBuilder::setScene(const sdk::SceneRecord& theirs) noexcept {
  keeping([&] {
    const auto r = sdk::adopt(theirs);
    scene_.name = textOf(r.name, "name");
    scene_.extras = textOf(r.extras, "extras");
    scene_.activeCamera = Id{r.activeCamera};
    scene_.nextId = Id{r.nextId};
    scene_.animation.framesPerSecond = r.framesPerSecond;
  });
}

void SceneBuilder::setRender(const sdk::RenderSettingsRecord& theirs) noexcept {
  keeping([&] {
    const auto r = sdk::adopt(theirs);
    if (r.filter > 1) problems_.push_back({"render.filter", "is unknown"});
    scene_.render = {.width = r.width,
                     .height = r.height,
                     .maxBounces = r.maxBounces,
                     .lightSamples = r.lightSamples,
                     .russianRoulette = r.russianRoulette != 0,
                     .errorMeter = r.errorMeter != 0,
                     .energyCompensation = r.energyCompensation != 0,
                     .clamp = r.clamp,
                     .filter = PixelFilter{r.filter},
                     .seed = r.seed};
  });
}

void SceneBuilder::setDisplay(const sdk::DisplaySettingsRecord& theirs) noexcept {
  keeping([&] {
    const auto r = sdk::adopt(theirs);
    if (r.transfer > 1) problems_.push_back({"display.transfer", "is unknown"});
    scene_.display = {.exposure = r.exposure,
                      .physical = r.physical != 0,
                      .ev100 = r.ev100,
                      .tonemapper = textOf(r.tonemapper, "display.tonemapper"),
                      .transfer = Transfer{r.transfer},
                      .gamma = r.gamma};
    for (std::uint64_t i = 0; i < r.parameterCount; ++i)
      scene_.display.parameters[textOf(r.parameters[i].id, "display.parameters")] =
          float(r.parameters[i].value);
  });
}

void SceneBuilder::addMaterial(const sdk::MaterialRecord& theirs) noexcept {
  keeping([&] {
    const auto r = sdk::adopt(theirs);
    const std::string where = "material #" + std::to_string(r.id);
    if (r.alphaMode > 2) problems_.push_back({where + ".alphaMode", "is unknown"});
    slots_.push_back({r.albedoTexture, r.metallicRoughnessTexture, r.normalTexture, r.emissionTexture});
    scene_.materials.push_back({.id = Id{r.id},
                                .name = textOf(r.name, where + ".name"),
                                .albedo = vec3Of(r.albedo),
                                .metallic = r.metallic,
                                .roughness = r.roughness,
                                .specular = r.specular,
                                .ior = r.ior,
                                .emissionColor = vec3Of(r.emissionColor),
                                .emissionLuminance = r.emissionLuminance,
                                .transmission = r.transmission,
                                .attenuationColor = vec3Of(r.attenuationColor),
                                .attenuationDistance = r.attenuationDistance,
                                .clearcoat = r.clearcoat,
                                .clearcoatRoughness = r.clearcoatRoughness,
                                .edgeTint = vec3Of(r.edgeTint),
                                .normalScale = r.normalScale,
                                .opacity = r.opacity,
                                .alphaMode = AlphaMode{r.alphaMode},
                                .alphaCutoff = r.alphaCutoff,
                                .thinWalled = r.thinWalled != 0,
                                .extras = textOf(r.extras, where + ".extras")});
  });
}

void SceneBuilder::addObject(const sdk::ObjectRecord& theirs) noexcept {
  keeping([&] {
    const auto r = sdk::adopt(theirs);
    const std::string where = "object #" + std::to_string(r.id);
    Object object{.id = Id{r.id}, .name = textOf(r.name, where + ".name"), .parent = Id{r.parent}};
    object.transform.translation = vec3Of(r.translation);
    object.transform.rotation = glm::dquat(r.rotation[3], r.rotation[0], r.rotation[1], r.rotation[2]);
    object.transform.scale = vec3Of(r.scale);
    object.visible = r.visible != 0;
    object.extras = textOf(r.extras, where + ".extras");
    if (r.projection > 1) problems_.push_back({where + ".camera.projection", "is unknown"});
    if (r.kind == sdk::ObjectKind::environmentLight) textOf(r.imageFile, where + ".light.file");
    if (!contentOf(r, object)) problems_.push_back({where, "is of an unknown kind"});
    meshIds_.push_back(r.kind == sdk::ObjectKind::mesh ? r.mesh : 0);
    scene_.objects.push_back(std::move(object));
  });
}

void SceneBuilder::addChannel(const sdk::ChannelRecord& theirs) noexcept {
  keeping([&] {
    const auto r = sdk::adopt(theirs);
    const std::string where = "animation.channels[" + std::to_string(scene_.animation.channels.size()) + "]";
    if (r.property > 4 || r.interpolation > 2)
      problems_.push_back({where, "has an unknown property or interpolation"});
    Channel channel{Id{r.target}, Property(r.property), Interpolation(r.interpolation)};
    for (std::uint64_t i = 0; i < r.keyCount; ++i) {
      const sdk::Key& key = r.keys[i];
      channel.keys.push_back({key.time, {key.value[0], key.value[1], key.value[2], key.value[3]}});
    }
    scene_.animation.channels.push_back(std::move(channel));
  });
}

void SceneBuilder::addMesh(const sdk::MeshRecord& mesh) noexcept {
  keeping([&] { heavy_.add(mesh, problems_); });
}

void SceneBuilder::addTexture(const sdk::TextureRecord& texture) noexcept {
  keeping([&] { heavy_.add(texture, problems_); });
}

/// Objects whose mesh is missing become groups, and a problem.
void SceneBuilder::linkMeshes() {
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    auto* geometry = std::get_if<Geometry>(&scene_.objects[i].content);
    auto* shape = geometry ? std::get_if<MeshShape>(&geometry->shape) : nullptr;
    if (!shape) continue;
    shape->mesh = heavy_.mesh(meshIds_[i]);
    if (shape->mesh) continue;
    problems_.push_back({"object #" + std::to_string(unsigned(scene_.objects[i].id)) + ".mesh",
                         "is " + std::to_string(meshIds_[i]) + "; there is no such mesh"});
    scene_.objects[i].content = Group{};
  }
}

void SceneBuilder::linkTextures() {
  for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
    Material& m = scene_.materials[i];
    const std::string where = "material #" + std::to_string(unsigned(m.id));
    m.albedoTexture = heavy_.slot(slots_[i].albedo, where + ".albedoTexture", problems_);
    m.metallicRoughnessTexture =
        heavy_.slot(slots_[i].metallicRoughness, where + ".metallicRoughnessTexture", problems_);
    m.normalTexture = heavy_.slot(slots_[i].normal, where + ".normalTexture", problems_);
    m.emissionTexture = heavy_.slot(slots_[i].emission, where + ".emissionTexture", problems_);
  }
}

Scene SceneBuilder::finish(std::vector<Problem>& problems) {
  std::uint32_t highest = 0;
  for (const Object& object : scene_.objects) highest = std::max(highest, std::uint32_t(object.id));
  for (const Material& material : scene_.materials) highest = std::max(highest, std::uint32_t(material.id));
  if (highest == UINT32_MAX)
    problems_.push_back({"id", "is 4294967295, the last there is; expected a smaller number"});
  else
    scene_.nextId = std::max(scene_.nextId, Id{highest + 1});
  linkMeshes();
  linkTextures();
  problems = std::move(problems_);
  const auto rules = problemsOf(scene_);
  problems.insert(problems.end(), rules.begin(), rules.end());
  return std::move(scene_);
}

}  // namespace steradian::plugins
