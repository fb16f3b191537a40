// SPDX-License-Identifier: MIT
// Meshes and textures on their way across the plugin border, both ways.
#include "plugins/host/heavy_records.hpp"

#include <cstring>

#include "plugins/host/utf8.hpp"

namespace steradian::plugins {

namespace {

constexpr std::uint64_t kMostElements = std::uint64_t(1) << 31;  // vertices, triangles

template <class Vector, class Number>
void fill(std::vector<Vector>& to, const Number* from, std::uint64_t count) {
  static_assert(sizeof(Vector) == sizeof(Number) * Vector::length());
  if (!from) return;
  to.resize(count);
  std::memcpy(static_cast<void*>(to.data()), from, count * sizeof(Vector));
}

template <class Number, class Vector>
const Number* dataOf(const std::vector<Vector>& values) {
  return values.empty() ? nullptr : &values[0][0];
}

Mesh meshOf(const sdk::MeshRecord& r) {
  Mesh mesh;
  mesh.name = isUtf8(r.name.view()) ? r.name.str() : std::string();
  fill(mesh.positions, r.positions, r.vertexCount);
  fill(mesh.triangles, r.triangles, r.triangleCount);
  fill(mesh.normals, r.normals, r.vertexCount);
  fill(mesh.tangents, r.tangents, r.vertexCount);
  fill(mesh.uv0, r.uv0, r.vertexCount);
  fill(mesh.uv1, r.uv1, r.vertexCount);
  fill(mesh.colors, r.colors, r.vertexCount);
  return mesh;
}

}  // namespace

void HeavyBuilder::add(const sdk::MeshRecord& theirs, std::vector<Problem>& problems) {
  const auto r = sdk::adopt(theirs);
  const std::string where = "mesh #" + std::to_string(r.id) + " '" + r.name.str() + "'";
  if (r.vertexCount > kMostElements || r.triangleCount > kMostElements)
    return problems.push_back({where, "has more than 2^31 vertices or triangles"});
  auto mesh = sharedMesh(meshOf(r));
  const std::string problem = problemOf(*mesh);
  if (!problem.empty()) return problems.push_back({where, problem});
  if (r.id == 0 || !meshes_.emplace(r.id, std::move(mesh)).second)
    problems.push_back({where, "has an id that is 0 or in use already; expected a unique positive number"});
}

void HeavyBuilder::add(const sdk::TextureRecord& theirs, std::vector<Problem>& problems) {
  const auto r = sdk::adopt(theirs);
  const std::string where = "texture #" + std::to_string(r.id);
  if (!isUtf8(r.name.view()) || !isUtf8(r.file.view()))
    return problems.push_back({where, "has a name that is not valid UTF-8"});
  Texture texture{.name = r.name.str(), .file = r.file.str()};
  const auto* bytes = static_cast<const std::uint8_t*>(r.bytes);
  if (bytes) texture.encoded.assign(bytes, bytes + r.byteCount);
  if (r.id == 0 || !textures_.emplace(r.id, std::make_shared<const Texture>(std::move(texture))).second)
    problems.push_back({where, "has an id that is 0 or in use already; expected a unique positive number"});
}

std::shared_ptr<const Mesh> HeavyBuilder::mesh(std::uint32_t id) const {
  const auto found = meshes_.find(id);
  return found == meshes_.end() ? nullptr : found->second;
}

TextureSlot HeavyBuilder::slot(const sdk::TextureSlotRecord& r, const std::string& where,
                               std::vector<Problem>& problems) const {
  if (r.texture == 0) return {};
  const auto found = textures_.find(r.texture);
  if (found == textures_.end())
    problems.push_back({where, "names texture #" + std::to_string(r.texture) + "; there is no such texture"});
  if (r.wrapU > 2 || r.wrapV > 2 || r.uvSet > 1)
    problems.push_back({where, "has an unknown wrap mode or UV set; expected wraps 0..2 and sets 0..1"});
  if (found == textures_.end() || r.wrapU > 2 || r.wrapV > 2 || r.uvSet > 1) return {};
  const float(&t)[6] = r.transform;
  return {found->second,      r.uvSet,           Wrap{r.wrapU}, Wrap{r.wrapV}, r.nearest != 0,
          {t[0], t[1], t[2]}, {t[3], t[4], t[5]}};
}

HeavyRecords::HeavyRecords(const Scene& scene) {
  for (const Object& object : scene.objects)
    if (const auto* geometry = std::get_if<Geometry>(&object.content))
      if (const auto* shape = std::get_if<MeshShape>(&geometry->shape)) add(*shape->mesh);
  for (const Material& m : scene.materials)
    for (const TextureSlot* slot :
         {&m.albedoTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.emissionTexture})
      if (slot->texture) add(*slot->texture);
}

void HeavyRecords::add(const Mesh& mesh) {
  const auto id = std::uint32_t(meshes.size() + 1);
  if (!meshIds_.emplace(&mesh, id).second) return;
  meshes.push_back({.id = id,
                    .name = mesh.name,
                    .vertexCount = mesh.positions.size(),
                    .triangleCount = mesh.triangles.size(),
                    .positions = dataOf<float>(mesh.positions),
                    .triangles = dataOf<std::uint32_t>(mesh.triangles),
                    .normals = dataOf<float>(mesh.normals),
                    .tangents = dataOf<float>(mesh.tangents),
                    .uv0 = dataOf<float>(mesh.uv0),
                    .uv1 = dataOf<float>(mesh.uv1),
                    .colors = dataOf<float>(mesh.colors)});
}

void HeavyRecords::add(const Texture& texture) {
  const auto id = std::uint32_t(textures.size() + 1);
  if (!textureIds_.emplace(&texture, id).second) return;
  textures.push_back({.id = id,
                      .name = texture.name,
                      .file = texture.file,
                      .bytes = texture.encoded.empty() ? nullptr : texture.encoded.data(),
                      .byteCount = texture.encoded.size()});
}

sdk::TextureSlotRecord HeavyRecords::slot(const TextureSlot& s) const {
  if (!s.texture) return {};
  return {.texture = textureIds_.at(s.texture.get()),
          .uvSet = s.uvSet,
          .wrapU = std::uint32_t(s.wrapU),
          .wrapV = std::uint32_t(s.wrapV),
          .nearest = s.nearest,
          .transform = {s.transformX.x, s.transformX.y, s.transformX.z, s.transformY.x, s.transformY.y,
                        s.transformY.z}};
}

}  // namespace steradian::plugins
