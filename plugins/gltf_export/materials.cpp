// SPDX-License-Identifier: MIT
// Materials and textures as glTF 2.0 and its ratified extensions say them.
#include "materials.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gltf_export {

namespace {

namespace sdk = steradian::sdk;

template <std::size_t N>
Json list(const float (&v)[N]) {
  Json out = Json::array();
  for (const float x : v) out.push_back(double(x));
  return out;
}

/// By the first bytes; glTF 2.0 holds these two. Empty = another format.
std::string mimeType(const sdk::TextureRecord& texture) {
  const auto* bytes = static_cast<const unsigned char*>(texture.bytes);
  if (texture.byteCount >= 8 && std::memcmp(bytes, "\x89PNG\r\n\x1a\n", 8) == 0) return "image/png";
  if (texture.byteCount >= 3 && std::memcmp(bytes, "\xff\xd8\xff", 3) == 0) return "image/jpeg";
  return {};
}

/// A relative path as a URI: everything but letters, digits and "-._~/" escaped (RFC 3986).
std::string uriOf(std::string_view path) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  std::string uri;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                       std::strchr("-._~/", c) != nullptr;
    if (plain)
      uri += c;
    else
      uri += {'%', kHex[byte >> 4], kHex[byte & 15]};
  }
  return uri;
}

int wrapMode(std::uint32_t wrap) {
  constexpr int kModes[] = {10497, 33071, 33648};  // REPEAT, CLAMP_TO_EDGE, MIRRORED_REPEAT
  return kModes[std::min(wrap, 2u)];
}

}  // namespace

Json extrasOf(const sdk::Text& extras, Json ours) {
  Json json = Json::parse(extras.view(), nullptr, false);
  if (!json.is_object()) json = Json::object();
  if (!ours.empty()) json["steradian"] = std::move(ours);
  return json;
}

Materials::Materials(Document& document, sdk::SceneView& scene, sdk::Host& host) : document_(document) {
  addImages(scene, host);
  for (std::uint64_t i = 0; i < scene.materialCount(); ++i) {
    const sdk::MaterialRecord& m = scene.material(i);
    records_.emplace(m.id, &m);
    indices_.emplace(std::pair(m.id, 2u), add(m, 2));  // the whole of it, whether used or not
  }
}

std::optional<std::size_t> Materials::find(std::uint32_t id, std::uint32_t uvSets) {
  const auto record = records_.find(id);
  if (record == records_.end()) return std::nullopt;
  const sdk::MaterialRecord& m = *record->second;
  std::uint32_t needed = 0;
  for (const sdk::TextureSlotRecord* slot :
       {&m.albedoTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.emissionTexture})
    if (images_.contains(slot->texture)) needed = std::max(needed, slot->uvSet + 1);
  const auto [at, isNew] = indices_.try_emplace({id, uvSets >= needed ? 2u : uvSets}, 0);
  if (isNew) at->second = add(m, uvSets);
  return at->second;
}

void Materials::addImages(sdk::SceneView& scene, sdk::Host& host) {
  for (std::uint64_t i = 0; i < scene.textureCount(); ++i) {
    const sdk::TextureRecord& texture = scene.texture(i);
    Json image = Json::object();
    if (texture.name.size) image["name"] = texture.name.str();
    const std::string mime = mimeType(texture);
    if (!mime.empty()) {
      const auto* bytes = static_cast<const std::uint8_t*>(texture.bytes);
      image["bufferView"] = document_.addBytes({bytes, std::size_t(texture.byteCount)});
      image["mimeType"] = mime;
    } else if (texture.byteCount == 0 && texture.file.size) {
      image["uri"] = uriOf(texture.file.view());
    } else {
      host.notKept("texture '" + texture.name.str() + "'", "glTF holds PNG and JPEG images only; left out");
      continue;
    }
    images_.emplace(texture.id, document_.append("images", std::move(image)));
  }
}

Json Materials::textureInfo(const sdk::TextureSlotRecord& slot, std::uint32_t uvSets) {
  const auto image = images_.find(slot.texture);
  if (image == images_.end() || slot.uvSet >= uvSets) return {};
  const int filter = slot.nearest ? 9728 : 9729;  // NEAREST, LINEAR
  const std::size_t sampler = document_.append(
      "samplers", {{"magFilter", filter}, {"wrapS", wrapMode(slot.wrapU)}, {"wrapT", wrapMode(slot.wrapV)}});
  Json info = {{"index", document_.append("textures", {{"sampler", sampler}, {"source", image->second}})}};
  if (slot.uvSet) info["texCoord"] = slot.uvSet;
  const float(&t)[6] = slot.transform;
  static constexpr float kIdentity[6] = {1, 0, 0, 0, 1, 0};
  if (!std::equal(t, t + 6, kIdentity)) {
    // Translation * rotation * scale; a shear has no place there and stays in extras.
    const double scaleX = std::hypot(t[0], t[3]), scaleY = std::hypot(t[1], t[4]);
    const double mirrored = t[0] * t[4] - t[1] * t[3] < 0 ? -1.0 : 1.0;
    document_.use("KHR_texture_transform");
    info["extensions"]["KHR_texture_transform"] = {{"offset", {double(t[2]), double(t[5])}},
                                                   {"rotation", std::atan2(-double(t[3]), double(t[0]))},
                                                   {"scale", {scaleX, mirrored * scaleY}}};
    info["extras"]["steradian"]["transform"] = list(t);
  }
  return info;
}

void Materials::addTextures(Json& json, const sdk::MaterialRecord& m, std::uint32_t uvSets) {
  Json& pbr = json["pbrMetallicRoughness"];
  if (Json info = textureInfo(m.albedoTexture, uvSets); !info.is_null())
    pbr["baseColorTexture"] = std::move(info);
  if (Json info = textureInfo(m.metallicRoughnessTexture, uvSets); !info.is_null())
    pbr["metallicRoughnessTexture"] = std::move(info);
  if (Json info = textureInfo(m.emissionTexture, uvSets); !info.is_null())
    json["emissiveTexture"] = std::move(info);
  if (Json info = textureInfo(m.normalTexture, uvSets); !info.is_null()) {
    info["scale"] = double(m.normalScale);
    json["normalTexture"] = std::move(info);
  }
}

void Materials::addEmission(Json& json, const float (&color)[3], float luminance) {
  if (!(luminance > 0)) return;
  // emissiveFactor is at most 1 each; what exceeds it goes into the strength.
  const float most = std::max({color[0], color[1], color[2], 1.0f});
  json["emissiveFactor"] = {double(color[0] / most), double(color[1] / most), double(color[2] / most)};
  document_.use("KHR_materials_emissive_strength");
  json["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", double(luminance) * most}};
}

void Materials::addExtensions(Json& json, const sdk::MaterialRecord& m) {
  const auto put = [&](const char* name, Json value) {
    document_.use(name);
    json["extensions"][name] = std::move(value);
  };
  addEmission(json, m.emissionColor, m.emissionLuminance);
  if (m.ior != 1.5f) put("KHR_materials_ior", {{"ior", double(m.ior)}});
  if (m.specular != 1.0f) put("KHR_materials_specular", {{"specularFactor", double(m.specular)}});
  if (m.transmission > 0) put("KHR_materials_transmission", {{"transmissionFactor", double(m.transmission)}});
  if (m.transmission > 0 && !m.thinWalled) {
    Json volume = {{"thicknessFactor", 1.0}};  // any positive one: a path tracer walks through the real solid
    volume["attenuationColor"] = list(m.attenuationColor);
    if (m.attenuationDistance > 0) volume["attenuationDistance"] = double(m.attenuationDistance);
    put("KHR_materials_volume", std::move(volume));
  }
  if (m.clearcoat > 0)
    put("KHR_materials_clearcoat", {{"clearcoatFactor", double(m.clearcoat)},
                                    {"clearcoatRoughnessFactor", double(m.clearcoatRoughness)}});
}

std::size_t Materials::add(const sdk::MaterialRecord& m, std::uint32_t uvSets) {
  Json json = Json::object();
  if (m.name.size) json["name"] = m.name.str();
  json["pbrMetallicRoughness"] = {
      {"baseColorFactor", {double(m.albedo[0]), double(m.albedo[1]), double(m.albedo[2]), double(m.opacity)}},
      {"metallicFactor", double(m.metallic)},
      {"roughnessFactor", double(m.roughness)}};
  addTextures(json, m, uvSets);
  addExtensions(json, m);
  if (m.alphaMode == 1) json["alphaMode"] = "MASK", json["alphaCutoff"] = double(m.alphaCutoff);
  if (m.alphaMode == 2) json["alphaMode"] = "BLEND";
  json["doubleSided"] = true;  // every surface here is
  Json ours = Json::object();
  if (m.edgeTint[0] != 1 || m.edgeTint[1] != 1 || m.edgeTint[2] != 1) ours["edgeTint"] = list(m.edgeTint);
  if (Json extras = extrasOf(m.extras, std::move(ours)); !extras.empty()) json["extras"] = std::move(extras);
  return document_.append("materials", std::move(json));
}

std::size_t Materials::addGlow(const float (&color)[3], float luminance) {
  Json json = {
      {"pbrMetallicRoughness",
       {{"baseColorFactor", {0.0, 0.0, 0.0, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}}};
  addEmission(json, color, luminance);
  return document_.append("materials", std::move(json));
}

}  // namespace gltf_export
