// SPDX-License-Identifier: MIT
#include "renderer/gpu_materials.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "renderer/gpu_textures.hpp"
#include "renderer/scene/fresnel.hpp"

namespace steradian {

using namespace gpu;

namespace {

constexpr float mirrorAlpha = 1e-3f;  // MIRROR_ALPHA in bsdf.glsl

Material bodyOf(const Light& light) {
  Material body;
  body.albedo = glm::vec3(0.0f);
  body.specular = 0.0f;
  body.roughness = 1.0f;
  body.emissionColor = lightColor(light);
  body.emissionLuminance = light.intensity;
  return body;
}

bool hasEdgeTint(const Material& m) {
  return m.metallic > 0.0f && m.edgeTint != glm::vec3(1.0f);
}

// What only meshes can show.
std::uint32_t meshBits(const Material& m, std::uint32_t vertexFlags) {
  const bool colors = (vertexFlags & MESH_COLORS) != 0;
  const bool textures = isUsable(m.albedoTexture) || isUsable(m.metallicRoughnessTexture) ||
                        isUsable(m.normalTexture) || isUsable(m.emissionTexture);
  const bool holes =
      m.alphaMode != AlphaMode::opaque && (m.opacity < 1.0f || colors || isUsable(m.albedoTexture));
  return (colors || textures ? FEATURE_TEXTURES : 0u) | (holes ? FEATURE_ALPHA | MATERIAL_ALPHA : 0u) |
         (holes && m.alphaMode == AlphaMode::mask ? MATERIAL_MASK : 0u) | (m.thinWalled ? MATERIAL_THIN : 0u);
}

}  // namespace

glm::vec3 absorptionOf(const Material& m) {
  if (m.transmission <= 0.0f || m.attenuationDistance <= 0.0f) return glm::vec3(0.0f);
  return -glm::log(glm::max(m.attenuationColor, glm::vec3(1e-6f))) / m.attenuationDistance;
}

Material materialOf(const Scene& scene, const SurfaceLink& link) {
  if (link.light) return bodyOf(*link.light);
  const Material* material = findMaterial(scene, link.material);
  return material ? *material : Material{};
}

std::uint32_t materialBits(const Material& m, const SurfaceLink& link) {
  const float alpha = m.roughness * m.roughness;
  const bool varied = link.vertexFlags && isUsable(m.metallicRoughnessTexture);
  const bool dielectric = m.metallic < 1.0f || varied;
  const bool glass = dielectric && m.transmission > 0.0f;
  const bool specular = m.metallic > 0.0f || m.specular > 0.0f || glass;
  const bool flatLight = link.light && !std::holds_alternative<SphereLight>(link.light->kind);
  return (dielectric && m.transmission < 1.0f ? FEATURE_DIFFUSE : 0u) |
         (specular && alpha >= mirrorAlpha ? FEATURE_GLOSSY : 0u) |
         (specular && (alpha < mirrorAlpha || varied) ? FEATURE_MIRROR : 0u) |
         (m.emissionLuminance > 0.0f ? FEATURE_EMISSION : 0u) | (flatLight ? MATERIAL_ONE_SIDED : 0u) |
         (glass ? FEATURE_TRANSMISSION : 0u) | (m.clearcoat > 0.0f ? FEATURE_CLEARCOAT : 0u) |
         (hasEdgeTint(m) ? FEATURE_EDGE_TINT : 0u) |
         (absorptionOf(m) != glm::vec3(0.0f) ? FEATURE_ABSORPTION : 0u) |
         (link.vertexFlags ? meshBits(m, *link.vertexFlags) : 0u);
}

bool isRoughGlass(std::uint32_t materialBits) {
  constexpr std::uint32_t both = FEATURE_TRANSMISSION | FEATURE_GLOSSY;
  return (materialBits & both) == both;
}

std::uint32_t GlassPlaces::rowOf(const Material& material, std::uint32_t materialBits,
                                 std::vector<glm::vec4>& rows) {
  if (!compensated_ || !isRoughGlass(materialBits)) return 0;
  const auto [place, isNew] = rows_.try_emplace(material.ior, std::uint32_t(rows.size()));
  if (isNew) {
    const auto table = tables_.of(material.ior);
    rows.insert(rows.end(), table->begin(), table->end());
  }
  return place->second;
}

void pushMaterial(std::vector<glm::vec4>& rows, const Material& m, std::uint32_t bits, std::uint32_t light,
                  const glm::uvec4& refs, std::uint32_t glassRow) {
  const float ratio = (m.ior - 1.0f) / (m.ior + 1.0f);
  // Glass reflects by Fresnel's equations, which know no weight.
  const float specular = m.transmission > 0.0f ? 1.0f : m.specular;
  const float coatAlpha = std::max(m.clearcoatRoughness * m.clearcoatRoughness, mirrorAlpha);
  rows.emplace_back(m.albedo, m.metallic);
  rows.emplace_back(m.roughness * m.roughness, specular * ratio * ratio, specular,
                    std::bit_cast<float>(bits));
  rows.emplace_back(m.emissionColor * m.emissionLuminance, std::bit_cast<float>(light));
  rows.emplace_back(m.transmission, m.ior, m.clearcoat, coatAlpha);
  rows.emplace_back(absorptionOf(m), std::bit_cast<float>(glassRow));
  rows.emplace_back(f82Coefficient(m.albedo, m.edgeTint), float(1.0 / meanTransmittance(m.ior)));
  rows.emplace_back(std::bit_cast<float>(refs.x), std::bit_cast<float>(refs.y), std::bit_cast<float>(refs.z),
                    std::bit_cast<float>(refs.w));
  rows.emplace_back(m.normalScale, m.opacity, m.alphaCutoff, 0.0f);
}

}  // namespace steradian
