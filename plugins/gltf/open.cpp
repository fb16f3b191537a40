// SPDX-License-Identifier: MIT
// From the bytes of a file to a Document: container, JSON, rules, buffers, typed model.
#include "open.hpp"

#include <algorithm>

#include "bytes.hpp"
#include "decompress.hpp"
#include "schema.hpp"
#include "views.hpp"

namespace gltf {

namespace {

constexpr std::string_view kKnown[] = {"EXT_meshopt_compression",
                                       "KHR_draco_mesh_compression",
                                       "KHR_lights_punctual",
                                       "KHR_materials_clearcoat",
                                       "KHR_materials_emissive_strength",
                                       "KHR_materials_ior",
                                       "KHR_materials_sheen",
                                       "KHR_materials_specular",
                                       "KHR_materials_transmission",
                                       "KHR_materials_unlit",
                                       "KHR_materials_volume",
                                       "KHR_mesh_quantization",
                                       "KHR_texture_transform"};

/// Asked before the rules: another version or an unknown extension may break any of them with good reason.
void refuseOtherVersions(const Json& json) {
  const Json asset = json.value("asset", Json());
  if (!asset.is_object()) return;  // the rules say so
  const Json version = asset.value("version", Json("2.0")), least = asset.value("minVersion", Json("2.0"));
  if (version.is_number() || (version.is_string() && version.get<std::string>().rfind("2.", 0) != 0))
    throw sdk::BadInput("asset.version: expected 2.0, got " + version.dump() +
                        "; convert the file to glTF 2.0");
  if (least.is_string() && least != "2.0")
    throw sdk::BadInput("asset.minVersion: expected 2.0, got " + least.dump() +
                        "; the file needs a newer reader");
}

void refuseUnknownExtensions(const Json& json) {
  const Json required = json.value("extensionsRequired", Json::array());
  if (!required.is_array()) return;
  for (const Json& name : required)
    if (name.is_string() && !knowsExtension(name.get<std::string>()))
      throw sdk::BadInput("extensionsRequired: the file cannot be shown without " + name.get<std::string>() +
                          ", which this importer does not know; save it without that extension");
}

/// What tinygltf 2.7.0 leaves out or refuses although it is sound.
void suitTinygltf(Json& json) {
  json["buffers"] = json["images"] = Json::array();
  if (json.contains("animations"))
    for (Json& animation : json["animations"])
      if (animation.contains("channels"))
        for (Json& channel : animation["channels"])
          if (!channel["target"].contains("node")) channel["target"]["node"] = -1;
  if (json.contains("skins"))
    for (Json& skin : json["skins"])
      if (!skin.contains("inverseBindMatrices")) skin["inverseBindMatrices"] = -1;
  const Json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
  if (json.contains(lights))
    for (Json& light : json[lights])
      if (light["type"] == "spot" && !light.contains("spot")) light["spot"] = Json::object();
}

/// tinygltf gets neither buffers nor images, and is built without file access: see tinygltf.hpp.
tinygltf::Model typedModel(Json json) {
  suitTinygltf(json);
  tinygltf::TinyGLTF reader;
  reader.SetStoreOriginalJSONForExtrasAndExtensions(true);
  tinygltf::Model model;
  std::string error, warning;
  const std::string text = json.dump();
  if (text.size() > UINT32_MAX) throw sdk::BadInput("has more than 4 GiB of JSON");
  if (!reader.LoadASCIIFromString(&model, &error, &warning, text.data(), unsigned(text.size()), "",
                                  tinygltf::NO_REQUIRE))
    throw sdk::BadInput("tinygltf says: " + error);
  return model;
}

/// Every node has one parent at most, and none is inside itself.
void refuseTangledNodes(const tinygltf::Model& model) {
  constexpr std::size_t kNone = std::size_t(-1);
  std::vector<std::size_t> parent(model.nodes.size(), kNone);
  for (std::size_t n = 0; n < model.nodes.size(); ++n)
    for (std::size_t c = 0; c < model.nodes[n].children.size(); ++c) {
      const auto child = std::size_t(model.nodes[n].children[c]);
      const std::string place = at(at("nodes", n) + ".children", c);
      if (child == n)
        throw sdk::BadInput(place + ": expected another node, got the node itself, " + std::to_string(n));
      if (parent[child] != kNone)
        throw sdk::BadInput(place + ": expected a node without a parent, got node " + std::to_string(child) +
                            ", which is a child of node " + std::to_string(parent[child]) + " already");
      parent[child] = n;
    }
  std::vector<std::size_t> seen(model.nodes.size(), kNone);  // from which start a node was reached first
  for (std::size_t start = 0; start < parent.size(); ++start)
    for (std::size_t n = start; n != kNone && seen[n] != start; n = parent[n]) {
      if (seen[n] != kNone) break;
      seen[n] = start;
      if (parent[n] != kNone && seen[parent[n]] == start)
        throw sdk::BadInput(at("nodes", n) + ": expected a tree of nodes, got a cycle through this one");
    }
  for (std::size_t s = 0; s < model.scenes.size(); ++s)
    for (std::size_t r = 0; r < model.scenes[s].nodes.size(); ++r)
      if (const auto root = std::size_t(model.scenes[s].nodes[r]); parent[root] != kNone)
        throw sdk::BadInput(at(at("scenes", s) + ".nodes", r) + ": expected a root node, got node " +
                            std::to_string(root) + ", a child of node " + std::to_string(parent[root]));
}

}  // namespace

bool knowsExtension(std::string_view name) {
  return std::find(std::begin(kKnown), std::end(kKnown), name) != std::end(kKnown);
}

Document openDocument(sdk::Host& host, std::string_view file) {
  const Container container = splitContainer(file);
  Json json = parseJson(container.text);
  refuseOtherVersions(json);
  refuseUnknownExtensions(json);
  Document document;
  document.unsound = checkValues(json);
  document.buffers = loadBuffers(host, json, container, document.decoded);
  decompress(json, document);
  document.model = typedModel(json);
  document.images = loadImages(
      host, json, [&](std::size_t view) { return bytesOfView(document, view); }, document.unsound,
      document.decoded);
  refuseTangledNodes(document.model);
  return document;
}

}  // namespace gltf
