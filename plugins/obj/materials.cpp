// SPDX-License-Identifier: MIT
// Phong terms -> metallic and roughness.
#include "materials.hpp"

#include <algorithm>
#include <cmath>

namespace obj {

namespace sdk = steradian::sdk;

namespace {

float highest(const float (&c)[3]) {
  return std::max({c[0], c[1], c[2]});
}
float unit(float value) {
  return std::clamp(value, 0.0f, 1.0f);
}

/// A height map bends normals when it is taken for a normal map, and nothing but its name tells them apart.
bool namesNormals(std::string name) {
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  const std::string stem = name.substr(0, name.rfind('.'));
  return name.find("norm") != name.npos || name.find("nrm") != name.npos || stem.ends_with("_n") ||
         name.find("ddn") != name.npos;
}

}  // namespace

std::uint32_t Materials::id(const std::string& name) {
  const auto [found, isNew] = ids_.try_emplace(name, 0);
  if (!isNew) return found->second;
  const auto phong = known_.find(name);
  if (phong == known_.end()) {
    if (!name.empty()) host_.notKept("material '" + name + "'", "left out: no library of the file has it");
    return 0;
  }
  const std::string text = utf8Of(name), where = "material '" + text + "'";
  sdk::MaterialRecord out;
  out.id = found->second = nextId_++;
  out.name = text;
  reflection(phong->second, where, out);
  maps(phong->second, where, out);
  sink_.addMaterial(out);
  return out.id;
}

/// Beckmann's alpha of Phong's exponent: 2 / alpha^2 = Ns + 2 (Walter et al. 2007, section 5.2).
void Materials::reflection(const Phong& phong, const std::string& where, sdk::MaterialRecord& out) {
  const bool metal = phong.metallic < 0 && highest(phong.specular) > 0.3f &&
                     highest(phong.diffuse) < 0.1f * highest(phong.specular);
  for (int i = 0; i < 3; ++i) out.albedo[i] = unit(metal ? phong.specular[i] : phong.diffuse[i]);
  out.metallic = phong.metallic >= 0 ? unit(phong.metallic) : float(metal);
  if (phong.roughness >= 0)
    out.roughness = unit(phong.roughness);
  else if (phong.shininess >= 0)
    out.roughness = unit(std::sqrt(std::sqrt(2 / (phong.shininess + 2))));
  // A grey Ks of 0.5 is what programs write for the reflectance of plastic.
  if (phong.roughness < 0 && phong.metallic < 0) {
    out.specular = metal ? 1.0f : unit(2 * (phong.specular[0] + phong.specular[1] + phong.specular[2]) / 3);
    host_.notKept(where, "approximated: Ks and Ns as metallic, specular and roughness");
  }
  out.ior = std::clamp(phong.ior, 1.0f, 100.0f);
  out.clearcoat = unit(phong.clearcoat);
  out.clearcoatRoughness = unit(phong.clearcoatRoughness);
  out.opacity = unit(phong.opacity);
  if (out.opacity < 1) out.alphaMode = 2;
  out.emissionLuminance = std::max(highest(phong.emission), 0.0f);
  if (out.emissionLuminance > 0)
    for (int i = 0; i < 3; ++i)
      out.emissionColor[i] = std::max(phong.emission[i], 0.0f) / out.emissionLuminance;
}

void Materials::maps(const Phong& phong, const std::string& where, sdk::MaterialRecord& out) {
  const auto fileOf = [&](const char* key) {
    const auto found = phong.maps.find(key);
    return found == phong.maps.end() ? std::string() : found->second.file;
  };
  const std::string opacity = fileOf("map_d"), roughness = fileOf("map_pr");
  for (const auto& [key, map] : phong.maps) {
    const bool normal =
        key == "norm" || key == "map_kn" || ((key == "bump" || key == "map_bump") && namesNormals(map.file));
    if (key == "map_kd") {
      out.albedoTexture = slot(map, where);
      if (out.albedoTexture.texture && highest(phong.diffuse) <= 0) std::fill_n(out.albedo, 3, 1.0f);
      if (opacity == map.file) out.alphaMode = 2;
    } else if (key == "map_ke") {
      out.emissionTexture = slot(map, where);
      if (out.emissionTexture.texture && out.emissionLuminance == 0) out.emissionLuminance = 1;
    } else if (normal) {
      out.normalTexture = slot(map, where);
      out.normalScale = map.strength;
    } else if (key == "map_pr" && (out.metallic == 0 || fileOf("map_pm") == map.file)) {
      out.metallicRoughnessTexture = slot(map, where);
      if (phong.roughness <= 0) out.roughness = 1;
    } else if (!(key == "map_d" && opacity == fileOf("map_kd")) &&
               !(key == "map_pm" && map.file == roughness)) {
      host_.notKept(where + " " + key + " " + map.file, "left out: is not rendered");
    }
  }
}

sdk::TextureSlotRecord Materials::slot(const Map& map, const std::string& where) {
  sdk::TextureSlotRecord out;
  out.texture = texture(map.file, where);
  if (out.texture == 0) return {};
  out.wrapU = out.wrapV = map.clamp ? 1 : 0;
  out.transform[0] = map.scale[0], out.transform[2] = map.offset[0];
  // v runs upwards in OBJ: v' = 1 - (scale (1 - v) + offset).
  out.transform[4] = map.scale[1], out.transform[5] = 1 - map.scale[1] - map.offset[1];
  return out;
}

std::uint32_t Materials::texture(const std::string& file, const std::string& where) {
  const auto [found, isNew] = textures_.try_emplace(file, 0);
  if (!isNew) return found->second;
  sdk::Text bytes;
  if (!host_.readBeside(file, bytes)) {
    host_.notKept(where + " texture " + file, "left out: " + bytes.str());
    return 0;
  }
  found->second = std::uint32_t(textures_.size());
  const std::string name = utf8Of(file.substr(file.rfind('/') + 1));
  sink_.addTexture({.id = found->second, .name = name, .bytes = bytes.data, .byteCount = bytes.size});
  return found->second;
}

}  // namespace obj
