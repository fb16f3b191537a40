// SPDX-License-Identifier: MIT
// Records -> .srad text: stable order, defaults left out, the fewest digits that read back to the same value.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "json_text.hpp"
#include "project.hpp"

namespace project {

namespace sdk = steradian::sdk;
using sdk::ObjectKind;

namespace {

/// 5 rather than 5.0; -0 keeps its sign.
OrderedJson number(double value) {
  const bool whole =
      value == std::floor(value) && std::abs(value) < 9e15 && !(value == 0 && std::signbit(value));
  return whole ? OrderedJson(std::int64_t(value)) : OrderedJson(value);
}

/// The double with the fewest digits that a float reads back from: 0.8, not 0.800000011920929.
OrderedJson number(float value) {
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, value);
  double shortest = value;
  std::from_chars(text, written.ptr, shortest);
  return number(float(shortest) == value ? shortest : double(value));
}

template <class Number>
OrderedJson list(const Number* values, std::size_t count) {
  OrderedJson out = OrderedJson::array();
  for (std::size_t i = 0; i < count; ++i) out.push_back(number(values[i]));
  return out;
}

/// Writes a key unless its value is the default.
class Keys {
 public:
  template <class Number>
  void put(const char* key, Number value, Number usual) {
    if (!same(value, usual)) json[key] = number(value);
  }
  template <class Number, std::size_t N>
  void put(const char* key, const Number (&values)[N], const Number (&usual)[N], std::size_t count = N) {
    if (!std::equal(values, values + count, usual, same<Number>)) json[key] = list(values, count);
  }
  void putWhole(const char* key, std::int64_t value, std::int64_t usual) {
    if (value != usual) json[key] = value;
  }
  void putFlag(const char* key, std::uint32_t value, std::uint32_t usual) {
    if ((value != 0) != (usual != 0)) json[key] = value != 0;
  }
  void putText(const char* key, const sdk::Text& value, std::string_view usual = {}) {
    if (value.view() != usual) json[key] = value.str();
  }
  OrderedJson json = OrderedJson::object();

 private:
  template <class Number>
  static bool same(Number a, Number b) {
    return a == b && std::signbit(a) == std::signbit(b);
  }
};

/// Adds the unknown keys of an earlier file. Known ones were settled above; inside of a known object that is
/// still there they are merged, so an old "sphere" does not come back on a box.
void addExtras(sdk::Host& host, OrderedJson& out, const sdk::Text& extras,
               std::initializer_list<const char*> known, bool atTop = false) {
  if (extras.view().empty()) return;
  Json theirs;
  try {
    theirs = parseJson(extras.view(), atTop ? kDeepest : kDeepest - 2);  // below { "objects": [
  } catch (const sdk::BadInput& error) {
    host.log("unknown keys were not saved: " + std::string(error.what()));
    return;
  }
  if (!theirs.is_object()) return;
  for (auto it = theirs.begin(); it != theirs.end(); ++it) {
    const bool isKnown = std::find(known.begin(), known.end(), it.key()) != known.end();
    const bool there = out.contains(it.key());
    if (there && out[it.key()].is_object() && it->is_object()) {
      for (auto inner = it->begin(); inner != it->end(); ++inner)
        if (!out[it.key()].contains(inner.key())) out[it.key()][inner.key()] = OrderedJson(*inner);
    } else if (!there && (!isKnown || (atTop && it->is_object()))) {
      out[it.key()] = OrderedJson(*it);
    }
  }
}

OrderedJson materialJson(sdk::Host& host, const sdk::MaterialRecord& m) {
  const sdk::MaterialRecord usual;
  Keys keys;
  keys.json["id"] = m.id;
  keys.putText("name", m.name);
  keys.put("albedo", m.albedo, usual.albedo);
  keys.put("metallic", m.metallic, usual.metallic);
  keys.put("roughness", m.roughness, usual.roughness);
  keys.put("specular", m.specular, usual.specular);
  keys.put("ior", m.ior, usual.ior);
  keys.put("emissionColor", m.emissionColor, usual.emissionColor);
  keys.put("emissionLuminance", m.emissionLuminance, usual.emissionLuminance);
  keys.put("transmission", m.transmission, usual.transmission);
  keys.put("attenuationColor", m.attenuationColor, usual.attenuationColor);
  keys.put("attenuationDistance", m.attenuationDistance, usual.attenuationDistance);
  keys.put("clearcoat", m.clearcoat, usual.clearcoat);
  keys.put("clearcoatRoughness", m.clearcoatRoughness, usual.clearcoatRoughness);
  keys.put("edgeTint", m.edgeTint, usual.edgeTint);
  addExtras(host, keys.json, m.extras,
            {"id", "name", "albedo", "metallic", "roughness", "specular", "ior", "emissionColor",
             "emissionLuminance", "transmission", "attenuationColor", "attenuationDistance", "clearcoat",
             "clearcoatRoughness", "edgeTint"});
  return keys.json;
}

void putLight(Keys& keys, const sdk::ObjectRecord& o, const sdk::ObjectRecord& usual) {
  keys.put("color", o.color, usual.color);
  keys.put("intensity", o.intensity, usual.intensity);
  keys.put("temperature", o.temperature, usual.temperature);
  if (o.kind == ObjectKind::spotLight) {
    keys.put("innerConeAngle", o.innerConeAngle, usual.innerConeAngle);
    keys.put("outerConeAngle", o.outerConeAngle, usual.outerConeAngle);
  }
  if (o.kind == ObjectKind::directionalLight)
    keys.put("angularDiameter", o.angularDiameter, usual.angularDiameter);
  if (o.kind == ObjectKind::sphereLight || o.kind == ObjectKind::diskLight)
    keys.put("radius", o.radius, usual.radius);
  if (o.kind == ObjectKind::rectLight) keys.put("size", o.dimensions, usual.dimensions, 2);
  if (o.kind != ObjectKind::environmentLight) return;
  keys.put("horizon", o.horizon, usual.horizon);
  keys.put("ground", o.ground, usual.ground);
  keys.putText("file", o.imageFile);
}

void putCamera(Keys& keys, const sdk::ObjectRecord& o, const sdk::ObjectRecord& usual) {
  keys.put("fovY", o.fovY, usual.fovY);
  if (o.projection != usual.projection) keys.json["projection"] = kProjections[o.projection];
  keys.put("orthographicHeight", o.orthographicHeight, usual.orthographicHeight);
  keys.put("fNumber", o.fNumber, usual.fNumber);
  keys.put("focusDistance", o.focusDistance, usual.focusDistance);
}

OrderedJson contentJson(const sdk::ObjectRecord& o) {
  const sdk::ObjectRecord usual = usualOf(o.kind);
  Keys keys;
  switch (o.kind) {
    case ObjectKind::group:
    case ObjectKind::plane:
      break;
    case ObjectKind::sphere:
    case ObjectKind::disk:
      keys.put("radius", o.radius, usual.radius);
      break;
    case ObjectKind::box:
      keys.put("size", o.dimensions, usual.dimensions);
      break;
    case ObjectKind::rect:
      keys.put("size", o.dimensions, usual.dimensions, 2);
      break;
    case ObjectKind::cylinder:
      keys.put("radius", o.radius, usual.radius);
      keys.put("height", o.height, usual.height);
      break;
    case ObjectKind::pointLight:
    case ObjectKind::spotLight:
    case ObjectKind::directionalLight:
    case ObjectKind::sphereLight:
    case ObjectKind::rectLight:
    case ObjectKind::diskLight:
    case ObjectKind::environmentLight:
      putLight(keys, o, usual);
      break;
    case ObjectKind::camera:
      putCamera(keys, o, usual);
      break;
  }
  return keys.json;
}

OrderedJson objectJson(sdk::Host& host, const sdk::ObjectRecord& o) {
  const sdk::ObjectRecord usual;
  Keys keys;
  keys.json["id"] = o.id;
  keys.putText("name", o.name);
  keys.putWhole("parent", o.parent, 0);
  keys.put("translation", o.translation, usual.translation);
  keys.put("rotation", o.rotation, usual.rotation);
  keys.put("scale", o.scale, usual.scale);
  keys.putFlag("visible", o.visible, 1);
  if (o.kind != ObjectKind::group) keys.json[kContents[std::uint32_t(o.kind)]] = contentJson(o);
  keys.putWhole("material", o.material, 0);
  addExtras(host, keys.json, o.extras,
            {"id",
             "name",
             "parent",
             "translation",
             "rotation",
             "scale",
             "visible",
             "material",
             "sphere",
             "plane",
             "box",
             "rect",
             "disk",
             "cylinder",
             "pointLight",
             "spotLight",
             "directionalLight",
             "camera",
             "sphereLight",
             "rectLight",
             "diskLight",
             "environmentLight"});
  return keys.json;
}

OrderedJson renderJson(const sdk::RenderSettingsRecord& r) {
  const sdk::RenderSettingsRecord usual;
  Keys keys;
  keys.putWhole("width", r.width, usual.width);
  keys.putWhole("height", r.height, usual.height);
  keys.putWhole("maxBounces", r.maxBounces, usual.maxBounces);
  keys.putWhole("lightSamples", r.lightSamples, usual.lightSamples);
  keys.putFlag("russianRoulette", r.russianRoulette, usual.russianRoulette);
  keys.putFlag("errorMeter", r.errorMeter, usual.errorMeter);
  keys.putFlag("energyCompensation", r.energyCompensation, usual.energyCompensation);
  keys.put("clamp", r.clamp, usual.clamp);
  if (r.filter != usual.filter) keys.json["filter"] = kFilters[r.filter];
  keys.putWhole("seed", r.seed, usual.seed);
  return keys.json;
}

OrderedJson displayJson(const sdk::DisplaySettingsRecord& d) {
  const sdk::DisplaySettingsRecord usual;
  Keys keys;
  keys.put("exposure", d.exposure, usual.exposure);
  keys.putFlag("physical", d.physical, usual.physical);
  keys.put("ev100", d.ev100, usual.ev100);
  keys.putText("tonemapper", d.tonemapper, usual.tonemapper.view());
  for (std::uint64_t i = 0; i < d.parameterCount; ++i)
    keys.json["parameters"][d.parameters[i].id.str()] = number(float(d.parameters[i].value));
  if (d.transfer != usual.transfer) keys.json["transfer"] = kTransfers[d.transfer];
  keys.put("gamma", d.gamma, usual.gamma);
  return keys.json;
}

OrderedJson channelJson(const sdk::ChannelRecord& c) {
  OrderedJson out;
  out["target"] = c.target;
  out["property"] = kProperties[c.property];
  if (c.interpolation != sdk::ChannelRecord{}.interpolation)
    out["interpolation"] = kInterpolations[c.interpolation];
  OrderedJson& keys = out["keys"] = OrderedJson::array();
  for (std::uint64_t i = 0; i < c.keyCount; ++i)
    keys.push_back(
        {{"time", number(c.keys[i].time)}, {"value", list(c.keys[i].value, kPropertySizes[c.property])}});
  return out;
}

OrderedJson animationJson(sdk::SceneView& view) {
  OrderedJson out = OrderedJson::object();
  const double fps = view.scene().framesPerSecond;
  if (fps != sdk::SceneRecord{}.framesPerSecond) out["framesPerSecond"] = number(fps);
  for (std::uint64_t i = 0; i < view.channelCount(); ++i)
    out["channels"].push_back(channelJson(view.channel(i)));
  return out;
}

std::uint32_t highestId(sdk::SceneView& view) {
  std::uint32_t highest = 0;
  for (std::uint64_t i = 0; i < view.materialCount(); ++i) highest = std::max(highest, view.material(i).id);
  for (std::uint64_t i = 0; i < view.objectCount(); ++i) highest = std::max(highest, view.object(i).id);
  return highest;
}

}  // namespace

void writeProject(sdk::Host& host, sdk::SceneView& view, sdk::Writer& writer) {
  const sdk::SceneRecord& scene = view.scene();
  Keys root;
  root.json["steradian"] = kVersion;
  root.putText("name", scene.name);
  root.putWhole("nextId", scene.nextId, std::int64_t(highestId(view)) + 1);
  root.putWhole("activeCamera", scene.activeCamera, 0);
  const auto section = [&](const char* key, OrderedJson value) {
    if (!value.empty()) root.json[key] = std::move(value);
  };
  section("render", renderJson(view.render()));
  section("display", displayJson(view.display()));
  OrderedJson materials = OrderedJson::array(), objects = OrderedJson::array();
  for (std::uint64_t i = 0; i < view.materialCount(); ++i)
    materials.push_back(materialJson(host, view.material(i)));
  for (std::uint64_t i = 0; i < view.objectCount(); ++i) {
    if (i % 4096 == 0 && host.cancelled()) throw sdk::Cancelled{};
    objects.push_back(objectJson(host, view.object(i)));
  }
  section("materials", std::move(materials));
  section("objects", std::move(objects));
  section("animation", animationJson(view));
  addExtras(host, root.json, scene.extras,
            {"steradian", "name", "nextId", "activeCamera", "render", "display", "materials", "objects",
             "animation"},
            true);
  const std::string text = jsonText(root.json);
  if (text.size() > kLargest)
    throw std::runtime_error("the project is larger than 256 MiB, the most that is read");
  writer.write(text.data(), text.size());
}

}  // namespace project
