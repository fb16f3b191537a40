// SPDX-License-Identifier: MIT
// .srad text -> records. Order of reading is the order of README.md.
#include <algorithm>
#include <vector>

#include "assets.hpp"
#include "texts.hpp"

namespace project {

namespace sdk = steradian::sdk;

namespace {

void checkVersion(const Json& root) {
  const auto version = root.find("steradian");
  if (version == root.end())
    throw sdk::BadInput(
        "/steradian: expected the format version, 1 or 2, got nothing; is this a Steradian project?");
  if (!version->is_number_unsigned() || *version == 0)
    failAt("/steradian", "the format version, 1 or 2", *version);
  if (*version > kVersion)
    throw sdk::BadInput("was written by a newer Steradian (version " + version->dump() +
                        "; this one reads up to " + std::to_string(kVersion) +
                        "); open it there, or update this one");
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

  readAssets(host, root, texts, sink);

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
