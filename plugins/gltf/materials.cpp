// SPDX-License-Identifier: MIT
// glTF 2.0 materials and their extensions as MaterialRecords.
#include "materials.hpp"

#include <algorithm>
#include <cmath>

#include "kept.hpp"
#include "restore.hpp"

namespace gltf {

namespace {

const tinygltf::Value* extensionOf(const tinygltf::Material& material, const char* name) {
  const auto found = material.extensions.find(name);
  return found == material.extensions.end() || !found->second.IsObject() ? nullptr : &found->second;
}

/// A number of an extension, or glTF's default.
double numberOf(const tinygltf::Value* extension, const char* key, double otherwise) {
  if (!extension || !extension->Has(key) || !extension->Get(key).IsNumber()) return otherwise;
  return extension->Get(key).GetNumberAsDouble();
}

bool colorOf(const tinygltf::Value* extension, const char* key, float (&out)[3]) {
  if (!extension || !extension->Has(key) || extension->Get(key).ArrayLen() != 3) return false;
  for (int i = 0; i < 3; ++i) out[i] = float(extension->Get(key).Get(i).GetNumberAsDouble());
  return true;
}

bool isOne(const float (&color)[3]) {
  return color[0] == 1 && color[1] == 1 && color[2] == 1;
}

}  // namespace

std::uint32_t Materials::id(int material) {
  const auto [at, first] = ids_.emplace(material, 0u);
  if (!first) return at->second;
  tinygltf::Material usual;
  usual.name = "glTF default";
  return at->second = add(material < 0 ? usual : document_.model.materials[std::size_t(material)], material);
}

std::uint32_t Materials::add(const tinygltf::Material& material, int index) {
  const std::string name = named("material", material.name, std::size_t(std::max(index, 0)));
  sdk::MaterialRecord out;
  out.id = nextId_++;
  const bool sound = report_.attempt(name, [&] {
    if (index >= 0) document_.demand(at("materials", std::size_t(index)));
  });
  if (sound) read(material, name, out);
  if (const Json tint = oursOf(material.extras_json_string).value("edgeTint", Json()); tint.size() == 3)
    for (std::size_t i = 0; i < 3; ++i)
      if (tint[i].is_number()) out.edgeTint[i] = std::clamp(tint[i].get<float>(), 0.0f, 1.0f);
  Json more = Json::object();
  if (material.doubleSided) more["doubleSided"] = true;
  const std::string extras = extrasText(keptOf(material, std::move(more)));
  out.name = material.name;
  out.extras = extras;
  sink_.addMaterial(out);
  return out.id;
}

void Materials::read(const tinygltf::Material& material, const std::string& name, sdk::MaterialRecord& out) {
  readCore(material, name, out);
  readTransmission(material, name, out);
  readCoats(material, name, out);
  if (extensionOf(material, "KHR_materials_unlit")) readUnlit(name, out);
}

void Materials::readCore(const tinygltf::Material& m, const std::string& name, sdk::MaterialRecord& out) {
  const auto& pbr = m.pbrMetallicRoughness;
  for (std::size_t i = 0; i < 3; ++i) out.albedo[i] = float(pbr.baseColorFactor[i]);
  out.opacity = float(pbr.baseColorFactor[3]);
  out.metallic = float(pbr.metallicFactor);
  out.roughness = float(pbr.roughnessFactor);
  out.albedoTexture = slot(pbr.baseColorTexture, name + ", base colour texture");
  out.metallicRoughnessTexture = slot(pbr.metallicRoughnessTexture, name + ", metallic-roughness texture");
  out.normalTexture = slot(m.normalTexture, name + ", normal texture");
  out.normalScale = float(m.normalTexture.scale);
  if (out.normalScale < 0) {
    report_.approximated(name + ", normal texture",
                         "its scale of " + std::to_string(out.normalScale) + " becomes 0");
    out.normalScale = 0;
  }
  if (m.occlusionTexture.index >= 0 && m.occlusionTexture.strength > 0)
    report_.dropped(name + ", occlusion texture", "a path tracer computes the occlusion");
  float factor[3] = {0, 0, 0};
  std::copy_n(m.emissiveFactor.begin(), std::min<std::size_t>(3, m.emissiveFactor.size()), factor);
  if (std::max({factor[0], factor[1], factor[2]}) > 0) {
    // Emissive 1.0 is taken for 1 nit, the unit that KHR_materials_emissive_strength names.
    std::copy_n(factor, 3, out.emissionColor);
    out.emissionLuminance =
        float(numberOf(extensionOf(m, "KHR_materials_emissive_strength"), "emissiveStrength", 1));
    out.emissionTexture = slot(m.emissiveTexture, name + ", emissive texture");
  }
  out.alphaMode = m.alphaMode == "MASK" ? 1 : m.alphaMode == "BLEND" ? 2 : 0;
  out.alphaCutoff = std::min(1.0f, float(m.alphaCutoff));
}

void Materials::readTransmission(const tinygltf::Material& m, const std::string& name,
                                 sdk::MaterialRecord& out) {
  const double ior = numberOf(extensionOf(m, "KHR_materials_ior"), "ior", 1.5);
  // 0 stands for infinity: all light is reflected.
  out.ior = ior == 0 ? 1000.0f : float(std::max(1.0, ior));
  if (ior < 1) report_.approximated(name + ", index of refraction", "it becomes " + std::to_string(out.ior));
  const auto* transmission = extensionOf(m, "KHR_materials_transmission");
  const auto* volume = extensionOf(m, "KHR_materials_volume");
  out.transmission = float(numberOf(transmission, "transmissionFactor", 0));
  dropTexture(transmission, "transmissionTexture", name);
  const bool solid = numberOf(volume, "thicknessFactor", 0) > 0;
  out.thinWalled = out.transmission > 0 && !solid;
  if (!solid) return;
  if (volume->Has("thicknessTexture"))
    report_.dropped(name + ", thicknessTexture", "rays measure the thickness of the mesh itself");
  colorOf(volume, "attenuationColor", out.attenuationColor);
  for (float& c : out.attenuationColor)
    c = std::max(c, 1e-6f);  // black would absorb at once: nearly the same
  const double distance = numberOf(volume, "attenuationDistance", 0);
  out.attenuationDistance = distance > 0 && distance <= 1e12 ? float(std::max(1e-12, distance)) : 0.0f;
}

void Materials::readCoats(const tinygltf::Material& m, const std::string& name, sdk::MaterialRecord& out) {
  const auto* coat = extensionOf(m, "KHR_materials_clearcoat");
  out.clearcoat = float(numberOf(coat, "clearcoatFactor", 0));
  out.clearcoatRoughness = float(numberOf(coat, "clearcoatRoughnessFactor", 0));
  for (const char* key : {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"})
    dropTexture(coat, key, name);
  const auto* specular = extensionOf(m, "KHR_materials_specular");
  out.specular = float(numberOf(specular, "specularFactor", 1));
  for (const char* key : {"specularTexture", "specularColorTexture"}) dropTexture(specular, key, name);
  float color[3] = {1, 1, 1};
  if (colorOf(specular, "specularColorFactor", color) && !isOne(color))
    report_.approximated(name + ", specular colour", "highlights of dielectrics are white");
  float sheen[3] = {0, 0, 0};
  if (colorOf(extensionOf(m, "KHR_materials_sheen"), "sheenColorFactor", sheen) &&
      std::max({sheen[0], sheen[1], sheen[2]}) > 0)
    report_.approximated(name + ", sheen", "it is left out; the material below it is exact");
}

void Materials::readUnlit(const std::string& name, sdk::MaterialRecord& out) {
  report_.approximated(name + ", unlit",
                       "a black surface that emits the base colour at 1 nit, and so lights others");
  std::copy_n(out.albedo, 3, out.emissionColor);
  out.emissionLuminance = 1;
  out.emissionTexture = out.albedoTexture;
  std::fill_n(out.albedo, 3, 0.0f);
  out.metallic = out.specular = out.transmission = out.clearcoat = 0;
  out.roughness = 1;
  out.thinWalled = 0;
  out.normalTexture = out.metallicRoughnessTexture = {};
  if (out.alphaMode == 0) out.albedoTexture = {};  // else its A still counts
}

void Materials::dropTexture(Extension extension, const char* key, const std::string& name) {
  if (extension && extension->Has(key))
    report_.dropped(name + ", " + key, "the factor alone counts, as if the texture were white");
}

}  // namespace gltf
