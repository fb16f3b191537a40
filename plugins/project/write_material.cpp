// SPDX-License-Identifier: MIT
// A material -> its line of .srad text.
#include "keys.hpp"

namespace project {

namespace sdk = steradian::sdk;

namespace {

void putSlot(Keys& material, const char* key, const sdk::TextureSlotRecord& slot) {
  if (slot.texture == 0) return;
  const sdk::TextureSlotRecord usual;
  Keys keys;
  keys.json["texture"] = slot.texture;
  keys.putWhole("uvSet", slot.uvSet, usual.uvSet);
  if (slot.wrapU != usual.wrapU) keys.json["wrapU"] = kWraps[slot.wrapU];
  if (slot.wrapV != usual.wrapV) keys.json["wrapV"] = kWraps[slot.wrapV];
  keys.putFlag("nearest", slot.nearest, usual.nearest);
  keys.put("transform", slot.transform, usual.transform);
  material.json[key] = std::move(keys.json);
}

void putMapped(Keys& keys, const sdk::MaterialRecord& m) {
  const sdk::MaterialRecord usual;
  putSlot(keys, "albedoTexture", m.albedoTexture);
  putSlot(keys, "metallicRoughnessTexture", m.metallicRoughnessTexture);
  putSlot(keys, "normalTexture", m.normalTexture);
  putSlot(keys, "emissionTexture", m.emissionTexture);
  keys.put("normalScale", m.normalScale, usual.normalScale);
  keys.put("opacity", m.opacity, usual.opacity);
  if (m.alphaMode != usual.alphaMode) keys.json["alphaMode"] = kAlphaModes[m.alphaMode];
  keys.put("alphaCutoff", m.alphaCutoff, usual.alphaCutoff);
  keys.putFlag("thinWalled", m.thinWalled, usual.thinWalled);
}

}  // namespace

bool needsVersion2(const sdk::MaterialRecord& material) {
  Keys keys;
  putMapped(keys, material);
  return !keys.json.empty();
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
  putMapped(keys, m);
  addExtras(host, keys.json, m.extras,
            {"id",
             "name",
             "albedo",
             "metallic",
             "roughness",
             "specular",
             "ior",
             "emissionColor",
             "emissionLuminance",
             "transmission",
             "attenuationColor",
             "attenuationDistance",
             "clearcoat",
             "clearcoatRoughness",
             "edgeTint",
             "albedoTexture",
             "metallicRoughnessTexture",
             "normalTexture",
             "emissionTexture",
             "normalScale",
             "opacity",
             "alphaMode",
             "alphaCutoff",
             "thinWalled"});
  return keys.json;
}

}  // namespace project
