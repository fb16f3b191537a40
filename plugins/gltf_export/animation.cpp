// SPDX-License-Identifier: MIT
// Channels as one glTF animation, and what glTF has no word for as extras.
#include <cmath>

#include "nodes.hpp"

namespace gltf_export {

namespace {

namespace sdk = steradian::sdk;
using Kind = sdk::ObjectKind;

constexpr const char* kPaths[] = {"translation", "rotation", "scale"};
constexpr const char* kInterpolations[] = {"STEP", "LINEAR", "CUBICSPLINE"};

/// Catmull-Rom's slope at a key, as the scene is played.
double slope(const sdk::ChannelRecord& c, std::uint64_t i, int component) {
  const sdk::Key& before = c.keys[i == 0 ? 0 : i - 1];
  const sdk::Key& after = c.keys[i + 1 < c.keyCount ? i + 1 : i];
  return after.time > before.time
             ? (after.value[component] - before.value[component]) / (after.time - before.time)
             : 0.0;
}

/// Rotations are played by slerp whatever the channel says, and a single key has no segment.
int interpolationOf(const sdk::ChannelRecord& c) {
  const bool straight = c.property == 1 || c.keyCount < 2;
  return c.interpolation == 2 && straight ? 1 : int(c.interpolation);
}

std::vector<float> outputs(const sdk::ChannelRecord& c, int components) {
  const bool cubic = interpolationOf(c) == 2;
  std::vector<float> out;
  for (std::uint64_t i = 0; i < c.keyCount; ++i)
    for (int part = cubic ? 0 : 1; part < (cubic ? 3 : 2); ++part)  // in-tangent, value, out-tangent
      for (int k = 0; k < components; ++k)
        out.push_back(float(part == 1 ? c.keys[i].value[k] : slope(c, i, k)));
  return out;
}

Json exactChannel(const sdk::ChannelRecord& c, std::size_t node) {
  Json keys = Json::array();
  for (std::uint64_t i = 0; i < c.keyCount; ++i) {
    const sdk::Key& key = c.keys[i];
    keys.push_back({key.time, key.value[0], key.value[1], key.value[2], key.value[3]});
  }
  return {{"node", node}, {"property", c.property}, {"interpolation", c.interpolation}, {"keys", keys}};
}

}  // namespace

void Nodes::addAnimation() {
  Json channels = Json::array(), samplers = Json::array(), exact = Json::array();
  for (std::uint64_t i = 0; i < scene_.channelCount(); ++i) {
    const sdk::ChannelRecord& c = scene_.channel(i);
    const auto node = indexOf_.find(c.target);
    if (node == indexOf_.end() || c.keyCount == 0) continue;
    exact.push_back(exactChannel(c, node->second));
    if (c.property > 2 || c.keys[0].time < 0) {
      host_.notKept("animation channel " + std::to_string(i),
                    "glTF animates transforms from time 0 on; kept in extras, for Steradian alone");
      continue;
    }
    std::vector<float> times;
    for (std::uint64_t k = 0; k < c.keyCount; ++k) times.push_back(float(c.keys[k].time));
    const int components = c.property == 1 ? 4 : 3;
    samplers.push_back({{"input", document_.addFloats(times, 1, Target::none, true)},
                        {"interpolation", kInterpolations[interpolationOf(c)]},
                        {"output", document_.addFloats(outputs(c, components), components, Target::none)}});
    channels.push_back({{"sampler", samplers.size() - 1},
                        {"target", {{"node", node->second}, {"path", kPaths[c.property]}}}});
  }
  if (exact.empty()) return;
  Json ours = {{"steradian", {{"framesPerSecond", scene_.scene().framesPerSecond}, {"channels", exact}}}};
  if (channels.empty())
    document_.root()["scenes"][0]["extras"].update(ours, true);
  else
    document_.append("animations", {{"channels", channels}, {"samplers", samplers}, {"extras", ours}});
}

Json exactObject(const sdk::ObjectRecord& o) {
  Json json = Json::object();
  const auto light = [&] {
    json["color"] = o.color;
    json["intensity"] = double(o.intensity);
    if (o.temperature != 0) json["temperature"] = double(o.temperature);
  };
  const auto kind = [&](const char* name) { json["kind"] = name; };
  switch (o.kind) {
    case Kind::sphere:
      kind("sphere"), json["radius"] = o.radius;
      break;
    case Kind::plane:
      kind("plane");
      break;
    case Kind::box:
      kind("box"), json["size"] = o.dimensions;
      break;
    case Kind::rect:
      kind("rect"), json["size"] = {o.dimensions[0], o.dimensions[1]};
      break;
    case Kind::disk:
      kind("disk"), json["radius"] = o.radius;
      break;
    case Kind::cylinder:
      kind("cylinder"), json["radius"] = o.radius, json["height"] = o.height;
      break;
    case Kind::pointLight:
    case Kind::spotLight:
      light();
      break;
    case Kind::directionalLight:
      light(), json["angularDiameter"] = double(o.angularDiameter);
      break;
    case Kind::sphereLight:
      kind("sphereLight"), light(), json["radius"] = o.radius;
      break;
    case Kind::rectLight:
      kind("rectLight"), light(), json["size"] = {o.dimensions[0], o.dimensions[1]};
      break;
    case Kind::diskLight:
      kind("diskLight"), light(), json["radius"] = o.radius;
      break;
    case Kind::environmentLight:
      kind("environmentLight"), light();
      json["horizon"] = o.horizon;
      json["ground"] = o.ground;
      if (o.imageFile.size) json["file"] = o.imageFile.str();
      break;
    case Kind::camera:
      json = {{"fNumber", o.fNumber}, {"focusDistance", o.focusDistance}};
      break;
    case Kind::group:
    case Kind::mesh:
      break;
  }
  return json;
}

}  // namespace gltf_export
