// SPDX-License-Identifier: MIT
// Meshes and textures -> files beside the project, named by their content, and the lists that name them.
#include "assets.hpp"
#include "mesh_file.hpp"

namespace project {

namespace sdk = steradian::sdk;

namespace {

/// "room.assets" for room.srad; a name that is no UTF-8 cannot stand in the text.
std::string folderOf(sdk::Writer& writer) try {
  OrderedJson(writer.stem().str()).dump();
  return writer.stem().str() + ".assets";
} catch (const OrderedJson::exception&) {
  return "project.assets";
}

const char* extensionOf(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return ".png";
  if (bytes.starts_with("\xff\xd8\xff")) return ".jpg";
  if (bytes.starts_with("\x76\x2f\x31\x01")) return ".exr";
  return bytes.starts_with("#?") ? ".hdr" : ".image";
}

}  // namespace

OrderedJson meshesJson(sdk::Host& host, sdk::SceneView& view, sdk::Writer& writer) {
  const std::string folder = folderOf(writer);
  OrderedJson out = OrderedJson::array();
  for (std::uint64_t i = 0; i < view.meshCount(); ++i) {
    if (host.cancelled()) throw sdk::Cancelled{};
    const sdk::MeshRecord& mesh = view.mesh(i);
    const std::string bytes = meshBytes(mesh), asset = folder + "/" + contentHash(bytes) + ".mesh";
    writer.writeBeside(asset, bytes.data(), bytes.size());
    Keys keys;
    keys.json["id"] = mesh.id;
    keys.putText("name", mesh.name);
    keys.json["asset"] = asset;
    out.push_back(std::move(keys.json));
  }
  return out;
}

OrderedJson texturesJson(sdk::Host& host, sdk::SceneView& view, sdk::Writer& writer) {
  const std::string folder = folderOf(writer);
  OrderedJson out = OrderedJson::array();
  for (std::uint64_t i = 0; i < view.textureCount(); ++i) {
    if (host.cancelled()) throw sdk::Cancelled{};
    const sdk::TextureRecord& texture = view.texture(i);
    Keys keys;
    keys.json["id"] = texture.id;
    keys.putText("name", texture.name);
    keys.putText("file", texture.file);
    if (texture.file.size == 0 && texture.byteCount > 0) {
      const std::string_view bytes(static_cast<const char*>(texture.bytes), texture.byteCount);
      const std::string asset = folder + "/" + contentHash(bytes) + extensionOf(bytes);
      writer.writeBeside(asset, bytes.data(), bytes.size());
      keys.json["asset"] = asset;
    }
    out.push_back(std::move(keys.json));
  }
  return out;
}

}  // namespace project
