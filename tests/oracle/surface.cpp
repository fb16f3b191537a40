// SPDX-License-Identifier: MIT
#include "tests/oracle/surface.hpp"

#include "tests/oracle/texture.hpp"

namespace steradian::oracle {
namespace {

using glm::dvec4;

/// The mesh that was met; null for analytic shapes.
const Mesh* meshOf(const Hit& hit) {
  const auto* shape = std::get_if<MeshShape>(&hit.body->shape);
  return shape ? shape->mesh.get() : nullptr;
}

/// One attribute between the triangle's corners.
template <class Wide, class Narrow>
Wide between(const std::vector<Narrow>& attribute, const Hit& hit) {
  const glm::uvec3& t = meshOf(hit)->triangles[hit.triangle];
  const double v = hit.barycentric.x, w = hit.barycentric.y;
  return (1.0 - v - w) * Wide(attribute[t.x]) + v * Wide(attribute[t.y]) + w * Wide(attribute[t.z]);
}

dvec4 textured(const TextureSlot& slot, const Hit& hit, bool color) {
  const Mesh& mesh = *meshOf(hit);
  const auto& set = slot.uvSet == 0 ? mesh.uv0 : mesh.uv1;
  return slot.texture && !set.empty() ? lookUp(slot, between<dvec2>(set, hit), color) : dvec4(1.0);
}

dvec4 vertexColor(const Hit& hit) {
  const auto& colors = meshOf(hit)->colors;
  return colors.empty() ? dvec4(1.0) : between<dvec4>(colors, hit);
}

}  // namespace

dvec3 shadingNormal(const Hit& hit) {
  const Mesh* mesh = meshOf(hit);
  if (!mesh || mesh->normals.empty()) return hit.normal;
  const dmat3 objectFromWorld(hit.body->objectFromWorld);
  const dvec3 n = glm::normalize(glm::transpose(objectFromWorld) * between<dvec3>(mesh->normals, hit));
  const Material& m = hit.body->finish->material;
  if (!m.normalTexture.texture || mesh->tangents.empty()) return n;
  const dvec4 tangent = between<dvec4>(mesh->tangents, hit);
  const dvec3 along = glm::inverse(objectFromWorld) * dvec3(tangent);
  const dvec3 t = glm::normalize(along - n * glm::dot(along, n)), b = glm::cross(n, t) * tangent.w;
  const dvec3 bend = 2.0 * dvec3(textured(m.normalTexture, hit, false)) - 1.0;
  return glm::normalize(bend.x * double(m.normalScale) * t + bend.y * double(m.normalScale) * b + bend.z * n);
}

std::optional<Finish> paintedFinish(const Hit& hit) {
  const Material& m = hit.body->finish->material;
  if (!meshOf(hit)) return {};
  const bool painted =
      m.albedoTexture.texture || m.metallicRoughnessTexture.texture || !meshOf(hit)->colors.empty();
  if (!painted) return {};
  Finish finish = *hit.body->finish;
  const dvec4 albedo = textured(m.albedoTexture, hit, true) * vertexColor(hit);
  const dvec4 metallicRoughness = textured(m.metallicRoughnessTexture, hit, false);
  finish.material.albedo *= glm::vec3(dvec3(albedo));
  finish.material.roughness *= float(metallicRoughness.y);
  finish.material.metallic *= float(metallicRoughness.z);
  return finish;
}

dvec3 emissionAt(const Hit& hit) {
  if (!hit.body->finish || !meshOf(hit)) return hit.body->emission;
  return hit.body->emission * dvec3(textured(hit.body->finish->material.emissionTexture, hit, true));
}

double opacityAt(const Hit& hit) {
  if (!hit.body->finish || !meshOf(hit)) return 1.0;
  const Material& m = hit.body->finish->material;
  if (m.alphaMode == AlphaMode::opaque) return 1.0;
  const double opacity = m.opacity * textured(m.albedoTexture, hit, true).w * vertexColor(hit).w;
  if (m.alphaMode == AlphaMode::mask) return opacity >= m.alphaCutoff ? 1.0 : 0.0;
  return opacity;
}

}  // namespace steradian::oracle
