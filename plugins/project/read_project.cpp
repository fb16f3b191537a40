// SPDX-License-Identifier: MIT
// .srad text -> records. Order of reading is the order of README.md.
#include <algorithm>
#include <deque>
#include <unordered_set>
#include <vector>

#include "fields.hpp"
#include "project.hpp"

namespace project {

namespace sdk = steradian::sdk;
using sdk::ObjectKind;

namespace {

/// Records point into these texts until the sink has copied them.
class Texts {
 public:
  sdk::Text keep(std::string text) { return texts_.emplace_back(std::move(text)); }
  sdk::Text read(Fields& fields, const char* key) {
    std::string text;
    fields.readText(key, text);
    return keep(std::move(text));
  }

 private:
  std::deque<std::string> texts_;
};

void checkVersion(const Json& root) {
  const auto version = root.find("steradian");
  if (version == root.end())
    throw sdk::BadInput(
        "/steradian: expected the format version 1, got nothing; is this a Steradian project?");
  if (!version->is_number_unsigned() || *version == 0)
    failAt("/steradian", "the format version, 1", *version);
  if (*version > kVersion)
    throw sdk::BadInput("was written by a newer Steradian (version " + version->dump() +
                        "; this one reads up to " + std::to_string(kVersion) +
                        "); open it there, or update this one");
}

void readLight(Fields& f, sdk::ObjectRecord& out, Texts& texts) {
  f.read("color", out.color, kNotNegative);
  f.read("intensity", out.intensity, kNotNegative);
  f.read("temperature", out.temperature, kNotNegative);
  if (out.kind == ObjectKind::spotLight) {
    f.read("innerConeAngle", out.innerConeAngle, kNotNegative);
    f.read("outerConeAngle", out.outerConeAngle, kPositive);
  }
  if (out.kind == ObjectKind::directionalLight) f.read("angularDiameter", out.angularDiameter, kNotNegative);
  if (out.kind == ObjectKind::sphereLight || out.kind == ObjectKind::diskLight)
    f.read("radius", out.radius, kPositive);
  if (out.kind == ObjectKind::rectLight) f.read("size", std::span(out.dimensions, 2), kPositive);
  if (out.kind != ObjectKind::environmentLight) return;
  f.read("horizon", out.horizon, kNotNegative);
  f.read("ground", out.ground, kNotNegative);
  out.imageFile = texts.read(f, "file");
}

void readCamera(Fields& f, sdk::ObjectRecord& out) {
  f.read("fovY", out.fovY, kPositive);
  f.readChoice("projection", out.projection, kProjections);
  f.read("orthographicHeight", out.orthographicHeight, kPositive);
  f.read("fNumber", out.fNumber, kNotNegative);
  f.read("focusDistance", out.focusDistance, kPositive);
}

void readContent(Fields f, sdk::ObjectRecord& out, Texts& texts) {
  out.radius = usualOf(out.kind).radius;
  std::ranges::copy(usualOf(out.kind).dimensions, out.dimensions);
  switch (out.kind) {
    case ObjectKind::group:
    case ObjectKind::plane:
      break;
    case ObjectKind::sphere:
    case ObjectKind::disk:
      f.read("radius", out.radius, kPositive);
      break;
    case ObjectKind::box:
      f.read("size", out.dimensions, kPositive);
      break;
    case ObjectKind::rect:
      f.read("size", std::span(out.dimensions, 2), kPositive);
      break;
    case ObjectKind::cylinder:
      f.read("radius", out.radius, kPositive);
      f.read("height", out.height, kPositive);
      break;
    case ObjectKind::pointLight:
    case ObjectKind::spotLight:
    case ObjectKind::directionalLight:
    case ObjectKind::sphereLight:
    case ObjectKind::rectLight:
    case ObjectKind::diskLight:
    case ObjectKind::environmentLight:
      readLight(f, out, texts);
      break;
    case ObjectKind::camera:
      readCamera(f, out);
      break;
  }
}

bool isShape(ObjectKind kind) {
  return kind >= ObjectKind::sphere && kind <= ObjectKind::cylinder;
}

sdk::ObjectRecord readObject(Fields& f, Texts& texts) {
  sdk::ObjectRecord out;
  f.readUnsigned("id", out.id, 1);
  out.name = texts.read(f, "name");
  f.readUnsigned("parent", out.parent);
  f.read("translation", out.translation);
  f.read("rotation", out.rotation);
  f.read("scale", out.scale);
  f.readFlag("visible", out.visible);
  for (std::uint32_t kind = 1; kind < std::size(kContents); ++kind) {
    if (!f.has(kContents[kind])) continue;
    if (out.kind != ObjectKind::group)
      throw sdk::BadInput(f.path() + ": expected one content, got both \"" +
                          kContents[std::uint32_t(out.kind)] + "\" and \"" + kContents[kind] + "\"");
    out.kind = ObjectKind{kind};
    f.within(kContents[kind], [&](Fields inner) { readContent(inner, out, texts); });
  }
  if (f.has("material") && !isShape(out.kind)) f.fail("material", "it only on an object with a shape");
  f.readUnsigned("material", out.material);
  out.extras = texts.keep(f.leftover());
  return out;
}

sdk::MaterialRecord readMaterial(Fields& f, Texts& texts) {
  static constexpr Range kIor{1, 1000, false, "a number from 1 to 1000"};
  sdk::MaterialRecord out;
  f.readUnsigned("id", out.id, 1);
  out.name = texts.read(f, "name");
  f.read("albedo", out.albedo, kUnit);
  f.read("metallic", out.metallic, kUnit);
  f.read("roughness", out.roughness, kUnit);
  f.read("specular", out.specular, kUnit);
  f.read("ior", out.ior, kIor);
  f.read("emissionColor", out.emissionColor, kNotNegative);
  f.read("emissionLuminance", out.emissionLuminance, kNotNegative);
  f.read("transmission", out.transmission, kUnit);
  f.read("attenuationColor", out.attenuationColor, kUnit);
  f.read("attenuationDistance", out.attenuationDistance, kNotNegative);
  f.read("clearcoat", out.clearcoat, kUnit);
  f.read("clearcoatRoughness", out.clearcoatRoughness, kUnit);
  f.read("edgeTint", out.edgeTint, kUnit);
  out.extras = texts.keep(f.leftover());
  return out;
}

void readRender(Fields f, sdk::SceneSink& sink) {
  sdk::RenderSettingsRecord out;
  f.readInteger("width", out.width, 1, 16384);
  f.readInteger("height", out.height, 1, 16384);
  f.readInteger("maxBounces", out.maxBounces, 0, 64);
  f.readInteger("lightSamples", out.lightSamples, 1, 16);
  f.readFlag("russianRoulette", out.russianRoulette);
  f.readFlag("errorMeter", out.errorMeter);
  f.readFlag("energyCompensation", out.energyCompensation);
  f.read("clamp", out.clamp, kNotNegative);
  f.readChoice("filter", out.filter, kFilters);
  f.readUnsigned("seed", out.seed);
  sink.setRender(out);
}

void readDisplay(Fields f, sdk::SceneSink& sink) {
  static constexpr Range kFloat{-3.4e38, 3.4e38, false, "a number that fits 32 bits"};
  sdk::DisplaySettingsRecord out;
  Texts texts;
  std::vector<sdk::ParameterValue> parameters;
  f.read("exposure", out.exposure);
  f.readFlag("physical", out.physical);
  f.read("ev100", out.ev100);
  if (f.has("tonemapper")) out.tonemapper = texts.read(f, "tonemapper");
  f.members("parameters", [&](const std::string& id, const Json& value, const std::string& path) {
    parameters.push_back({texts.keep(id), numberFrom(value, path, kFloat)});
  });
  f.readChoice("transfer", out.transfer, kTransfers);
  f.read("gamma", out.gamma, kPositive);
  out.parameters = parameters.data();
  out.parameterCount = parameters.size();
  sink.setDisplay(out);
}

void warnAbout(sdk::Host& host, const Fields& f) {
  if (!f.leftover().empty())
    host.notKept(f.path(), "unknown keys inside an animation channel: " + f.leftover());
}

void readChannel(sdk::Host& host, Fields& f, sdk::SceneSink& sink) {
  sdk::ChannelRecord out;
  std::vector<sdk::Key> keys;
  f.readUnsigned("target", out.target, 1);
  if (!f.has("property")) f.fail("property", "the name of what is animated");
  f.readChoice("property", out.property, kProperties);
  f.readChoice("interpolation", out.interpolation, kInterpolations);
  f.each("keys", [&](Fields key) {
    sdk::Key& each = keys.emplace_back();
    key.read("time", each.time);
    key.read("value", std::span(each.value, kPropertySizes[out.property]));
    warnAbout(host, key);
  });
  warnAbout(host, f);
  out.keys = keys.data();
  out.keyCount = keys.size();
  sink.addChannel(out);
}

/// Gives free ids to those that were written without one.
template <class Record>
void nameTheNameless(std::vector<Record>& records, std::uint32_t& next) {
  for (Record& record : records)
    if (record.id == 0) record.id = next++;
}

std::uint32_t firstFreeId(std::uint32_t asked, const std::vector<sdk::ObjectRecord>& objects,
                          const std::vector<sdk::MaterialRecord>& materials) {
  std::uint32_t highest = asked > 0 ? asked - 1 : 0;
  for (const auto& object : objects) highest = std::max(highest, object.id);
  for (const auto& material : materials) highest = std::max(highest, material.id);
  return highest + 1;
}

}  // namespace

void readProject(sdk::Host& host, std::string_view bytes, sdk::SceneSink& sink) {
  Json json = parseJson(bytes);
  Fields root(json, "");
  checkVersion(json);
  json.erase("steradian");

  Texts texts;
  sdk::SceneRecord scene;
  scene.name = texts.read(root, "name");
  root.readUnsigned("nextId", scene.nextId, 1);
  root.readUnsigned("activeCamera", scene.activeCamera);
  root.within("render", [&](Fields f) { readRender(f, sink); });
  root.within("display", [&](Fields f) { readDisplay(f, sink); });

  std::vector<sdk::MaterialRecord> materials;
  std::vector<sdk::ObjectRecord> objects;
  root.each("materials", [&](Fields f) { materials.push_back(readMaterial(f, texts)); });
  root.each("objects", [&](Fields f) {
    if (objects.size() % 4096 == 0 && host.cancelled()) throw sdk::Cancelled{};
    objects.push_back(readObject(f, texts));
  });
  root.within("animation", [&](Fields f) {
    f.read("framesPerSecond", scene.framesPerSecond, kPositive);
    f.each("channels", [&](Fields channel) { readChannel(host, channel, sink); });
  });
  scene.extras = texts.keep(root.leftover());

  std::uint32_t next = firstFreeId(scene.nextId, objects, materials);
  nameTheNameless(materials, next);
  nameTheNameless(objects, next);
  scene.nextId = next;
  sink.setScene(scene);
  for (const auto& material : materials) sink.addMaterial(material);
  for (const auto& object : objects) sink.addObject(object);
}

}  // namespace project
