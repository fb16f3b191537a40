// SPDX-License-Identifier: MIT
// One element of "materials" -> a record.
#include "texts.hpp"

namespace project {

namespace sdk = steradian::sdk;

namespace {

void readSlot(Fields& material, const char* key, sdk::TextureSlotRecord& out) {
  material.within(key, [&](Fields f) {
    if (!f.has("texture")) f.fail("texture", "the id of an element of \"textures\"");
    f.readUnsigned("texture", out.texture, 1);
    std::int32_t uvSet = 0;
    f.readInteger("uvSet", uvSet, 0, 1);
    out.uvSet = std::uint32_t(uvSet);
    f.readChoice("wrapU", out.wrapU, kWraps);
    f.readChoice("wrapV", out.wrapV, kWraps);
    f.readFlag("nearest", out.nearest);
    f.read("transform", out.transform);
  });
}

void readMapped(Fields& f, sdk::MaterialRecord& out) {
  static constexpr Range kScale{0, 100, false, "a number from 0 to 100"};
  readSlot(f, "albedoTexture", out.albedoTexture);
  readSlot(f, "metallicRoughnessTexture", out.metallicRoughnessTexture);
  readSlot(f, "normalTexture", out.normalTexture);
  readSlot(f, "emissionTexture", out.emissionTexture);
  f.read("normalScale", out.normalScale, kScale);
  f.read("opacity", out.opacity, kUnit);
  f.readChoice("alphaMode", out.alphaMode, kAlphaModes);
  f.read("alphaCutoff", out.alphaCutoff, kUnit);
  f.readFlag("thinWalled", out.thinWalled);
}

}  // namespace

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
  readMapped(f, out);
  out.extras = texts.keep(f.leftover());
  return out;
}

}  // namespace project
