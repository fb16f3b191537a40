// SPDX-License-Identifier: MIT
// What Steradian's own exporter wrote beside glTF, under extras.steradian: shapes, lights and keys as they
// were.
#include "restore.hpp"

#include <cmath>

#include "restore_fields.hpp"
#include "transforms.hpp"

namespace gltf {

namespace {

using sdk::ObjectKind;

constexpr double kSmall = 1e-12, kLarge = 1e12;

/// `count` numbers.
template <class Number>
void readMany(const Json& json, const char* key, Number* out, std::size_t count, double low, double high) {
  if (!json.contains(key)) return;
  if (!json[key].is_array() || json[key].size() != count) failField(key, std::to_string(count) + " numbers");
  for (std::size_t i = 0; i < count; ++i) out[i] = Number(numberIn(json[key][i], key, low, high));
}

ObjectKind kindOf(const Json& name) {
  static const std::map<std::string, ObjectKind> kKinds = {
      {"sphere", ObjectKind::sphere},
      {"plane", ObjectKind::plane},
      {"box", ObjectKind::box},
      {"rect", ObjectKind::rect},
      {"disk", ObjectKind::disk},
      {"cylinder", ObjectKind::cylinder},
      {"sphereLight", ObjectKind::sphereLight},
      {"rectLight", ObjectKind::rectLight},
      {"diskLight", ObjectKind::diskLight},
      {"environmentLight", ObjectKind::environmentLight}};
  const auto found = name.is_string() ? kKinds.find(name.get<std::string>()) : kKinds.end();
  if (found == kKinds.end()) failField("kind", "a shape or a light");
  return found->second;
}

bool isLight(ObjectKind kind) {
  return kind == ObjectKind::pointLight || kind == ObjectKind::spotLight ||
         kind == ObjectKind::directionalLight ||
         (kind >= ObjectKind::sphereLight && kind <= ObjectKind::environmentLight);
}

void readSize(const Json& ours, sdk::ObjectRecord& out) {
  const bool three = out.kind == ObjectKind::box;
  if (three || out.kind == ObjectKind::rect || out.kind == ObjectKind::rectLight)
    readMany(ours, "size", out.dimensions, three ? 3 : 2, kSmall, kLarge);
  readField(ours, "radius", out.radius, kSmall, kLarge);
  readField(ours, "height", out.height, kSmall, kLarge);
}

void readLight(const Json& ours, OwnObject& out) {
  readMany(ours, "color", out.record.color, 3, 0, kLarge);
  readField(ours, "intensity", out.record.intensity, 0, kLarge);
  readField(ours, "temperature", out.record.temperature, 1000, 40000);
  readField(ours, "angularDiameter", out.record.angularDiameter, 0, 1.5707);
  readMany(ours, "horizon", out.record.horizon, 3, 0, kLarge);
  readMany(ours, "ground", out.record.ground, 3, 0, kLarge);
  if (!ours.contains("file")) return;
  if (!ours["file"].is_string()) failField("file", "a text");
  out.imageFile = ours["file"];
}

sdk::Key keyOf(const Json& json, std::uint32_t property) {
  if (!json.is_array() || json.size() != 5) failField("channels.keys", "a time and four numbers each");
  sdk::Key key;
  key.time = numberIn(json[0], "channels.keys", -kLarge, kLarge);
  for (std::size_t i = 0; i < 4; ++i)
    key.value[i] = numberIn(json[i + 1], "channels.keys", property > 2 ? 0 : -kLarge, kLarge);
  double length = 0;
  for (const double v : key.value) length += v * v;
  if (property == 1 && std::abs(std::sqrt(length) - 1) > 1e-6) failField("channels.keys", "unit quaternions");
  if (property == 2) {
    const glm::dvec3 scale = awayFromZero({key.value[0], key.value[1], key.value[2]});
    for (int i = 0; i < 3; ++i) key.value[i] = scale[i];
  }
  return key;
}

}  // namespace

Json oursOf(const std::string& text) {
  const Json extras = text.empty() ? Json() : Json::parse(text);
  Json ours = extras.is_object() ? extras.value("steradian", Json()) : Json();
  return ours.is_object() ? ours : Json::object();
}

OwnObject restoreObject(const Json& ours, const sdk::ObjectRecord& start, std::size_t materials) {
  OwnObject out;
  out.record = start;
  if (ours.contains("visible")) {
    if (!ours["visible"].is_boolean()) failField("visible", "true or false");
    out.record.visible = ours["visible"].get<bool>();
  }
  if (ours.contains("kind")) {
    out.analytic = true;
    out.record.kind = kindOf(ours["kind"]);
    readSize(ours, out.record);
    if (ours.contains("material"))
      out.material = int(numberIn(ours["material"], "material", 0, double(materials) - 1));
  }
  if (isLight(out.record.kind)) readLight(ours, out);
  if (out.record.kind == ObjectKind::camera) {
    if (ours.contains("fNumber") && ours["fNumber"] != 0)
      readField(ours, "fNumber", out.record.fNumber, kSmall, kLarge);
    readField(ours, "focusDistance", out.record.focusDistance, kSmall, kLarge);
  }
  return out;
}

std::vector<OwnChannel> restoreChannels(const Json& ours, std::size_t nodes) {
  std::vector<OwnChannel> out;
  const Json channels = ours.value("channels", Json::array());
  if (!channels.is_array()) failField("channels", "an array");
  for (const Json& json : channels) {
    if (!json.is_object() || !json.contains("node") || !json["node"].is_number_unsigned() ||
        json["node"] >= nodes || !json.contains("keys") || !json["keys"].is_array() || json["keys"].empty())
      failField("channels", "a node and keys");
    OwnChannel& each = out.emplace_back();
    each.node = json["node"];
    readField(json, "property", each.property, 0, 4);
    readField(json, "interpolation", each.interpolation, 0, 2);
    for (const Json& key : json["keys"]) {
      each.keys.push_back(keyOf(key, each.property));
      const std::size_t n = each.keys.size();
      if (n > 1 && !(each.keys[n - 1].time > each.keys[n - 2].time))
        failField("channels.keys", "increasing times");
    }
  }
  return out;
}

}  // namespace gltf
