// SPDX-License-Identifier: MIT
// The lists "meshes" and "textures" -> records, with the bytes of the files that they name.
#include "assets.hpp"
#include "mesh_file.hpp"

namespace project {

namespace sdk = steradian::sdk;

namespace {

void readMesh(sdk::Host& host, Fields& f, Texts& texts, sdk::SceneSink& sink) {
  std::uint32_t id = 0;
  if (!f.has("id") || !f.has("asset"))
    f.fail(f.has("id") ? "asset" : "id", "an id > 0 and the name of a .mesh file");
  f.readUnsigned("id", id, 1);
  const sdk::Text name = texts.read(f, "name"), asset = texts.read(f, "asset");
  const std::string place = f.path() + "/asset: ";
  sdk::Text bytes;
  if (!host.readBeside(asset, bytes))
    throw sdk::BadInput(place + bytes.str() + "; the files of a project's .assets folder belong beside it");
  try {
    sdk::MeshRecord mesh = meshFrom(bytes.view());
    mesh.id = id, mesh.name = name;
    sink.addMesh(mesh);
  } catch (const sdk::BadInput& error) {
    throw sdk::BadInput(place + asset.str() + " " + error.what() + "; copy it anew from a good project");
  }
  if (!f.leftover().empty()) host.notKept(f.path(), "unknown keys of a mesh: " + f.leftover());
}

void readTexture(sdk::Host& host, Fields& f, Texts& texts, sdk::SceneSink& sink) {
  sdk::TextureRecord out;
  if (!f.has("id")) f.fail("id", "an id > 0");
  f.readUnsigned("id", out.id, 1);
  out.name = texts.read(f, "name");
  out.file = texts.read(f, "file");
  const sdk::Text asset = texts.read(f, "asset");
  if (out.file.size > 0 && asset.size > 0)
    throw sdk::BadInput(f.path() + ": expected either \"file\" or \"asset\", got both");
  sdk::Text bytes;
  if (asset.size > 0 && host.readBeside(asset, bytes))
    out.bytes = bytes.data, out.byteCount = bytes.size;
  else if (asset.size > 0)
    out.file = asset;
  sink.addTexture(out);
  if (!f.leftover().empty()) host.notKept(f.path(), "unknown keys of a texture: " + f.leftover());
}

}  // namespace

void readAssets(sdk::Host& host, Fields& root, Texts& texts, sdk::SceneSink& sink) {
  root.each("meshes", [&](Fields f) {
    if (host.cancelled()) throw sdk::Cancelled{};
    readMesh(host, f, texts, sink);
  });
  root.each("textures", [&](Fields f) {
    if (host.cancelled()) throw sdk::Cancelled{};
    readTexture(host, f, texts, sink);
  });
}

}  // namespace project
