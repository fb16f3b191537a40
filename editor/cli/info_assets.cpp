// SPDX-License-Identifier: MIT
// steradian info: meshes, textures and what an import made of its file.
#include "editor/cli/info_assets.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "editor/cli/console.hpp"
#include "editor/textures.hpp"

namespace steradian::cli {

namespace {

template <class Element>
std::size_t bytesOf(const std::vector<Element>& values) {
  return values.size() * sizeof(Element);
}

std::size_t bytesOf(const Mesh& m) {
  return bytesOf(m.positions) + bytesOf(m.triangles) + bytesOf(m.normals) + bytesOf(m.tangents) +
         bytesOf(m.uv0) + bytesOf(m.uv1) + bytesOf(m.colors);
}

std::string memory(std::size_t bytes) {
  return bytes < 1 << 20 ? text("%.1f KiB", double(bytes) / 1024)
                         : text("%.1f MiB", double(bytes) / (1 << 20));
}

std::string attributesOf(const Mesh& m) {
  std::string out;
  for (const auto& [there, name] : {std::pair(!m.normals.empty(), "normals"),
                                    {!m.tangents.empty(), "tangents"},
                                    {!m.uv0.empty(), "uv0"},
                                    {!m.uv1.empty(), "uv1"},
                                    {!m.colors.empty(), "colors"}})
    if (there) out += (out.empty() ? "" : ", ") + std::string(name);
  return out.empty() ? "none" : out;
}

const char* nameOf(TexturePixels::Format format) {
  static constexpr const char* kNames[] = {"8-bit", "16-bit", "half float"};
  return kNames[std::size_t(format)];
}

}  // namespace

Json meshInfo(const Scene& scene) {
  std::vector<std::pair<const Mesh*, int>> meshes;
  for (const Object& object : scene.objects) {
    const auto* geometry = std::get_if<Geometry>(&object.content);
    const auto* shape = geometry ? std::get_if<MeshShape>(&geometry->shape) : nullptr;
    if (!shape) continue;
    const auto found = std::ranges::find(meshes, shape->mesh.get(), &std::pair<const Mesh*, int>::first);
    found == meshes.end() ? void(meshes.emplace_back(shape->mesh.get(), 1)) : void(++found->second);
  }
  Json out = Json::array();
  for (const auto& [mesh, objects] : meshes)
    out.push_back({{"name", mesh->name},
                   {"triangles", mesh->triangles.size()},
                   {"vertices", mesh->positions.size()},
                   {"attributes", attributesOf(*mesh)},
                   {"objects", objects},
                   {"memory", memory(bytesOf(*mesh))}});
  return out;
}

Json textureInfo(const Scene& scene) {
  Json out = Json::array();
  for (const auto& texture : texturesOf(scene)) {
    const TexturePixels& p = texture->pixels;
    Json each = {{"name", texture->name}, {"file", texture->file.empty() ? "embedded" : texture->file}};
    if (p.width == 0) {
      each["size"] = "missing or damaged";
    } else {
      each["size"] = text("%dx%d", p.width, p.height);
      each["format"] = nameOf(p.format);
      each["memory"] = memory(p.bytes.size());
    }
    out.push_back(std::move(each));
  }
  return out;
}

Json importInfo(const plugins::ImportReport& report) {
  Json approximated = Json::array(), dropped = Json::array(), remarks = Json::array();
  for (const auto& [what, why] : report.notKept) {
    const std::string_view reason = why;
    Json& list = reason.starts_with("approximated") ? approximated
                 : reason.starts_with("left out")   ? dropped
                                                    : remarks;
    list.push_back(what + ": " + std::string(reason.substr(std::min(reason.find(": ") + 2, reason.size()))));
    if (&list == &remarks) list.back() = what + ": " + why;
  }
  const bool all = report.notKept.empty();
  return {{"exact", all ? "everything" : "everything that is not named here"},
          {"approximated", approximated},
          {"dropped", dropped},
          {"remarks", remarks}};
}

}  // namespace steradian::cli
