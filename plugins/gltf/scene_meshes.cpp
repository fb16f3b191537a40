// SPDX-License-Identifier: MIT
// The meshes of nodes: what is equal is shared, what is skinned or morphed is baked.
#include "kept.hpp"
#include "scene_writer.hpp"

namespace gltf {

namespace {

constexpr std::uint64_t kMostElements = std::uint64_t(1) << 28;

template <class Number, class Vector>
const Number* dataOf(const std::vector<Vector>& values) {
  return values.empty() ? nullptr : &values[0][0];
}

std::string keyOf(const tinygltf::Primitive& primitive, const std::string& bendKey) {
  std::string key = std::to_string(primitive.mode) + " " + std::to_string(primitive.indices);
  for (const auto& [name, accessor] : primitive.attributes)
    key += " " + name + ":" + std::to_string(accessor);
  return key + bendKey;
}

}  // namespace

std::vector<SceneWriter::Content> SceneWriter::meshContents(std::size_t index, const std::string& name) {
  const tinygltf::Node& node = document_.model.nodes[index];
  if (node.mesh < 0) return {};
  const tinygltf::Mesh& mesh = document_.model.meshes[std::size_t(node.mesh)];
  Bend bend{pose_.weights[index].empty() ? mesh.weights : pose_.weights[index], {}};
  std::string bendKey;
  for (std::size_t i = 0; i < bend.weights.size(); ++i)
    if (bend.weights[i] != 0) bendKey += " w" + std::to_string(i) + "=" + std::to_string(bend.weights[i]);
  if (!bendKey.empty()) {
    bendKey = " mesh " + std::to_string(node.mesh) + bendKey;  // targets are the mesh's own
    report_.approximated("mesh of '" + name + "'",
                         "its morph targets are baked as they stand at the parameter time");
  }
  const bool skinned = node.skin >= 0;
  if (skinned) {
    bendKey += " skin " + std::to_string(node.skin);
    if (!report_.attempt("mesh of '" + name + "'",
                         [&] { bend.joints = jointsOfSkin(std::size_t(node.skin)); }))
      return {};
    report_.approximated("mesh of '" + name + "'", "its skin is baked as it stands at the parameter time");
  }
  std::vector<Content> out;
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p)
    if (auto content = primitiveContent(index, p, bend, bendKey)) out.push_back(std::move(*content));
  if (!skinned) return out;
  // A skin stands in the world, whatever its node does: objects without a parent.
  for (Content& content : out) {
    content.record.id = nextId_++;
    push(content.record, content.name.empty() ? name : content.name, content);
  }
  return {};
}

std::optional<SceneWriter::Content> SceneWriter::primitiveContent(std::size_t node, std::size_t index,
                                                                  const Bend& bend,
                                                                  const std::string& bendKey) {
  const auto meshIndex = std::size_t(document_.model.nodes[node].mesh);
  const tinygltf::Mesh& mesh = document_.model.meshes[meshIndex];
  const tinygltf::Primitive& primitive = mesh.primitives[index];
  const std::string place = at(at("meshes", meshIndex) + ".primitives", index);
  const std::string name =
      named("mesh", mesh.name, meshIndex) +
      (mesh.primitives.size() > 1 ? ", primitive " + std::to_string(index) : std::string());
  Content out;
  out.record.mesh = meshId(primitive, place, name, bend, bendKey);
  if (out.record.mesh == 0) return std::nullopt;
  out.record.kind = sdk::ObjectKind::mesh;
  out.record.material = materials_.id(primitive.material);
  if (mesh.primitives.size() > 1) {
    out.kept["primitive"] = index;
    if (primitive.material >= 0) out.name = document_.model.materials[std::size_t(primitive.material)].name;
  }
  if (!mesh.name.empty()) out.kept["mesh"] = mesh.name;
  if (const Json kept = keptOf(mesh); !kept.empty()) out.kept["ofMesh"] = kept;
  return out;
}

std::uint32_t SceneWriter::meshId(const tinygltf::Primitive& primitive, const std::string& place,
                                  const std::string& name, const Bend& bend, const std::string& bendKey) {
  const std::string key = document_.unsound.count(place) ? place : keyOf(primitive, bendKey);
  const auto [at, first] = meshes_.emplace(key, 0u);
  if (!first) return at->second;
  report_.attempt(name, [&, &id = at->second] {
    const Triangles t = readPrimitive(document_, primitive, place, bend);
    elements_ += t.positions.size() + t.indices.size() / 3;
    if (elements_ > kMostElements)
      throw sdk::BadInput("the file makes more than 2^28 vertices and triangles");
    for (const std::string& note : t.notes) report_.approximated(name, note);
    id = std::uint32_t(meshes_.size());
    sink_.addMesh({.id = id,
                   .name = name,
                   .vertexCount = t.positions.size(),
                   .triangleCount = t.indices.size() / 3,
                   .positions = dataOf<float>(t.positions),
                   .triangles = t.indices.data(),
                   .normals = dataOf<float>(t.normals),
                   .tangents = dataOf<float>(t.tangents),
                   .uv0 = dataOf<float>(t.uv0),
                   .uv1 = dataOf<float>(t.uv1),
                   .colors = dataOf<float>(t.colors)});
  });
  return at->second;
}

const std::vector<glm::dmat4>& SceneWriter::jointsOfSkin(std::size_t skin) {
  const auto found = skins_.find(skin);
  return found != skins_.end() ? found->second
                               : skins_.emplace(skin, jointsOf(document_, skin, pose_)).first->second;
}

}  // namespace gltf
