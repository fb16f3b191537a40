// SPDX-License-Identifier: MIT
// Metallic-roughness material as glTF 2.0 defines it (appendix B), with KHR_materials_specular's weight.
#pragma once
#include <string>

#include <glm/glm.hpp>

#include "renderer/scene/ids.hpp"
#include "renderer/scene/texture.hpp"

namespace steradian {

/// What the opacity of a point means: ignored, all or nothing at a threshold, or the share that is there.
enum class AlphaMode : std::uint32_t { opaque = 0, mask = 1, blend = 2 };

struct Material {
  Id id = Id::none;
  std::string name;
  glm::vec3 albedo{0.8f};  // base colour, linear Rec. 709, each in [0, 1]
  float metallic = 0.0f;   // [0, 1]
  float roughness = 0.5f;  // perceptual, [0, 1]; alpha = roughness^2; below 0.0316 a perfect mirror lobe
  float specular = 1.0f;   // weight of the dielectric lobe, [0, 1]; 0 = pure Lambert
  float ior = 1.5f;        // index of refraction, >= 1; F0 = ((ior-1)/(ior+1))^2
  glm::vec3 emissionColor{1.0f};   // linear Rec. 709, >= 0
  float emissionLuminance = 0.0f;  // nit (cd/m^2) times emissionColor, >= 0, both sides
  // Transmission replaces this share of the diffuse base: refraction through solids (Box, Sphere, Cylinder,
  // Plane), panes of two faces for thin ones (Rect, Disk), straight or, when rough, scattered. Tinted by
  // albedo.
  float transmission = 0.0f;         // [0, 1]
  glm::vec3 attenuationColor{1.0f};  // what a solid leaves of white light after attenuationDistance, (0, 1]
  float attenuationDistance = 0.0f;  // metres, >= 0; 0 = clear
  float clearcoat = 0.0f;            // weight of a dielectric coat of ior 1.5 on top, [0, 1]
  float clearcoatRoughness = 0.0f;   // perceptual, [0, 1]
  glm::vec3 edgeTint{1.0f};  // metals: reflectance at 82 degrees beside Schlick's, [0, 1]; 1 = plain Schlick
  // On meshes only. Textures multiply the factors above; albedo and emission are sRGB unless half float.
  TextureSlot albedoTexture;             // RGB times albedo, A times opacity
  TextureSlot metallicRoughnessTexture;  // G times roughness, B times metallic
  TextureSlot normalTexture;             // tangent space, x and y times normalScale
  TextureSlot emissionTexture;           // RGB times emissionColor
  float normalScale = 1.0f;              // [0, 100]
  float opacity = 1.0f;                  // [0, 1]
  AlphaMode alphaMode = AlphaMode::opaque;
  float alphaCutoff = 0.5f;  // mask: opaque from here on, [0, 1]
  bool thinWalled = false;   // transmission through a sheet that encloses nothing
  std::string extras;        // unknown keys of the project file, as JSON text; kept on round trip

  bool operator==(const Material&) const = default;
};

}  // namespace steradian
