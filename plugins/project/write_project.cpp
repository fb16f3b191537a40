// SPDX-License-Identifier: MIT
// Records -> .srad text: stable order, defaults left out, the fewest digits that read back to the same value.
#include <algorithm>

#include "assets.hpp"
#include "keys.hpp"

namespace project {

namespace sdk = steradian::sdk;

namespace {

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

/// The oldest version that holds the whole scene: what reads it does not lose anything.
std::uint32_t versionOf(sdk::SceneView& view) {
  bool meshes = view.meshCount() > 0;
  for (std::uint64_t i = 0; i < view.materialCount(); ++i) meshes = meshes || needsVersion2(view.material(i));
  return meshes ? 2 : 1;
}

}  // namespace

void writeProject(sdk::Host& host, sdk::SceneView& view, sdk::Writer& writer) {
  const sdk::SceneRecord& scene = view.scene();
  Keys root;
  root.json["steradian"] = versionOf(view);
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
  section("meshes", meshesJson(host, view, writer));
  section("textures", texturesJson(host, view, writer));
  section("materials", std::move(materials));
  section("objects", std::move(objects));
  section("animation", animationJson(view));
  addExtras(host, root.json, scene.extras,
            {"steradian", "name", "nextId", "activeCamera", "render", "display", "meshes", "textures",
             "materials", "objects", "animation"},
            true);
  const std::string text = jsonText(root.json);
  if (text.size() > kLargest)
    throw std::runtime_error("the project is larger than 256 MiB, the most that is read");
  writer.write(text.data(), text.size());
}

}  // namespace project
