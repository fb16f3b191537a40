// SPDX-License-Identifier: MIT
// Objects as nodes with meshes, lights and cameras.
#include "nodes.hpp"

#include <algorithm>
#include <cmath>

#include "settings.hpp"
#include "surfaces.hpp"

namespace gltf_export {

namespace {

namespace sdk = steradian::sdk;
using Kind = sdk::ObjectKind;

std::string placeOf(const sdk::ObjectRecord& o) {
  return "object '" + o.name.str() + "'";
}

std::vector<float> unitVectors(const float* values, std::size_t count, int stride) {
  std::vector<float> out(values, values + count * std::size_t(stride));
  for (std::size_t i = 0; i < count; ++i) {
    float* v = &out[i * std::size_t(stride)];
    const float length = std::hypot(v[0], v[1], v[2]);
    // A vertex without a direction still needs a unit vector in the file.
    const float fallback[3] = {0, 1, 0};
    for (int c = 0; c < 3; ++c) v[c] = length > 0 ? v[c] / length : fallback[c];
    if (stride == 4) v[3] = v[3] < 0 ? -1.0f : 1.0f;
  }
  return out;
}

std::vector<float> clamped(const float* values, std::size_t count) {
  std::vector<float> out(values, values + count);
  for (float& v : out) v = std::clamp(v, 0.0f, 1.0f);
  return out;
}

}  // namespace

void Nodes::write() {
  std::vector<Json> nodes;
  for (std::uint64_t i = 0; i < scene_.objectCount(); ++i) {
    const sdk::ObjectRecord& o = scene_.object(i);
    indexOf_.emplace(o.id, i);
    nodes.push_back(node(o));
  }
  link(nodes);
  addAnimation();
}

Json Nodes::node(const sdk::ObjectRecord& o) {
  Json node = Json::object();
  if (o.name.size) node["name"] = o.name.str();
  const auto put = [&](const char* key, const auto& values, const auto& standard) {
    if (!std::equal(std::begin(values), std::end(values), std::begin(standard))) node[key] = values;
  };
  const sdk::ObjectRecord standard;
  put("translation", o.translation, standard.translation);
  put("rotation", o.rotation, standard.rotation);
  put("scale", o.scale, standard.scale);
  addContent(node, o);
  Json ours = exactObject(o);
  if (!o.visible) ours["visible"] = false;
  // A shape's mesh may show a material without its textures.
  if (const auto material = materials_.find(o.material, 2); material && tessellated(o))
    ours["material"] = *material;
  if (Json extras = extrasOf(o.extras, std::move(ours)); !extras.empty()) node["extras"] = std::move(extras);
  return node;
}

void Nodes::addContent(Json& node, const sdk::ObjectRecord& o) {
  if (o.kind == Kind::mesh) addMesh(node, o);
  if (o.kind == Kind::camera) addCamera(node, o);
  if (o.kind == Kind::pointLight || o.kind == Kind::spotLight || o.kind == Kind::directionalLight)
    addLight(node, o);
  if (o.kind == Kind::environmentLight)
    host_.notKept(placeOf(o), "glTF has no sky; kept in extras, for Steradian alone");
  addSurface(node, o);
}

Json Nodes::attributes(const sdk::MeshRecord& m) {
  const auto floats = [&](const auto& values, int components) {
    return document_.addFloats(values, components, Target::vertices);
  };
  const auto count = std::size_t(m.vertexCount);
  Json json = {{"POSITION", document_.addFloats({m.positions, count * 3}, 3, Target::vertices, true)}};
  if (m.normals) json["NORMAL"] = floats(unitVectors(m.normals, count, 3), 3);
  if (m.tangents && m.normals) json["TANGENT"] = floats(unitVectors(m.tangents, count, 4), 4);
  if (m.uv0) json["TEXCOORD_0"] = floats(std::span(m.uv0, count * 2), 2);
  if (m.uv1 && m.uv0) json["TEXCOORD_1"] = floats(std::span(m.uv1, count * 2), 2);
  if (m.colors) json["COLOR_0"] = floats(clamped(m.colors, count * 4), 4);
  return json;
}

void Nodes::addMesh(Json& node, const sdk::ObjectRecord& o) {
  const sdk::MeshRecord& mesh = scene_.mesh(o.mesh - 1);
  if (mesh.triangleCount == 0 || mesh.vertexCount == 0)
    return host_.notKept(placeOf(o), "its mesh is empty, which glTF forbids; the node is kept");
  const auto [at, isNew] = meshes_.try_emplace({o.mesh, o.material}, 0);
  if (isNew) {
    auto& [vertices, indices] = primitives_[o.mesh];
    if (vertices.is_null()) {
      vertices = attributes(mesh);
      indices = document_.addIndices({mesh.triangles, std::size_t(mesh.triangleCount) * 3});
    }
    Json primitive = {{"attributes", vertices}, {"indices", indices}};
    const std::uint32_t uvSets = mesh.uv0 ? (mesh.uv1 ? 2 : 1) : 0;
    if (const auto material = materials_.find(o.material, uvSets)) primitive["material"] = *material;
    Json json = {{"primitives", Json::array({primitive})}};
    if (mesh.name.size) json["name"] = mesh.name.str();
    at->second = document_.append("meshes", std::move(json));
  }
  node["mesh"] = at->second;
}

void Nodes::addSurface(Json& node, const sdk::ObjectRecord& o) {
  const auto surface = tessellated(o);
  if (!surface) return;
  const Json attributes = {{"POSITION", document_.addFloats(surface->positions, 3, Target::vertices, true)},
                           {"NORMAL", document_.addFloats(surface->normals, 3, Target::vertices)}};
  Json primitive = {{"attributes", attributes}, {"indices", document_.addIndices(surface->indices)}};
  const bool glows = o.kind == Kind::sphereLight || o.kind == Kind::rectLight || o.kind == Kind::diskLight;
  if (glows) primitive["material"] = materials_.addGlow(o.color, o.intensity);
  if (const auto material = materials_.find(o.material, 0); material && !glows)
    primitive["material"] = *material;
  if (o.kind == Kind::plane)
    host_.notKept(placeOf(o), "the infinite plane ends after 1 km for other programs");
  node["mesh"] = document_.append("meshes", {{"primitives", Json::array({primitive})}});
}

void Nodes::addLight(Json& node, const sdk::ObjectRecord& o) {
  const float most = std::max({o.color[0], o.color[1], o.color[2], 1.0f});  // colours end at 1
  Json light = {{"type", o.kind == Kind::spotLight          ? "spot"
                         : o.kind == Kind::directionalLight ? "directional"
                                                            : "point"},
                {"color", {double(o.color[0] / most), double(o.color[1] / most), double(o.color[2] / most)}},
                {"intensity", double(o.intensity) * most}};
  if (o.kind == Kind::spotLight)
    light["spot"] = {{"innerConeAngle", double(o.innerConeAngle)},
                     {"outerConeAngle", double(o.outerConeAngle)}};
  document_.use("KHR_lights_punctual");
  Json& lights = document_.root()["extensions"]["KHR_lights_punctual"]["lights"];
  lights.push_back(std::move(light));
  node["extensions"]["KHR_lights_punctual"] = {{"light", lights.size() - 1}};
}

void Nodes::addCamera(Json& node, const sdk::ObjectRecord& o) {
  const double aspect = double(scene_.render().width) / scene_.render().height;
  Json camera;
  if (o.projection == 1)
    camera = {{"type", "orthographic"},
              {"orthographic",
               {{"xmag", 0.5 * o.orthographicHeight * aspect},
                {"ymag", 0.5 * o.orthographicHeight},
                {"znear", 0.0},
                {"zfar", 10000.0}}}};
  else
    camera = {{"type", "perspective"},
              {"perspective", {{"aspectRatio", aspect}, {"yfov", o.fovY}, {"znear", 0.001}}}};
  node["camera"] = document_.append("cameras", std::move(camera));
}

/// Children into their parents, roots into the scene.
void Nodes::link(std::vector<Json>& nodes) {
  Json roots = Json::array();
  for (std::uint64_t i = 0; i < scene_.objectCount(); ++i) {
    const auto parent = indexOf_.find(scene_.object(i).parent);
    if (parent == indexOf_.end())
      roots.push_back(i);
    else
      nodes[parent->second]["children"].push_back(i);
  }
  for (Json& node : nodes) document_.append("nodes", std::move(node));
  Json scene = Json::object();
  if (scene_.scene().name.size) scene["name"] = scene_.scene().name.str();
  if (!roots.empty()) scene["nodes"] = std::move(roots);
  Json settings = settingsOf(scene_);
  if (const auto camera = indexOf_.find(scene_.scene().activeCamera); camera != indexOf_.end())
    settings["activeCamera"] = camera->second;
  scene["extras"] = extrasOf(scene_.scene().extras, std::move(settings));
  document_.root()["scene"] = document_.append("scenes", std::move(scene));
}

}  // namespace gltf_export
