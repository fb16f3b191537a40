// SPDX-License-Identifier: MIT
// Writes scenes as glTF 2.0: .gltf with its buffer beside it, or .glb in one file.
#include <cstring>
#include <steradian/plugin.hpp>

#include "materials.hpp"
#include "nodes.hpp"

namespace gltf_export {

namespace {

namespace sdk = steradian::sdk;

Document documentOf(sdk::Host& host, sdk::SceneView& scene) {
  Document document;
  Materials materials(document, scene, host);
  Nodes(document, materials, scene, host).write();
  return document;
}

/// 64-bit FNV-1a: a new content gets a new name, so that a half-finished save never mixes two versions.
std::string contentName(std::span<const std::uint8_t> bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 1099511628211ull;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

class Gltf final : public sdk::Exporter {
 public:
  Gltf()
      : Exporter({.id = "org.steradian.gltf_export",
                  .name = "glTF 2.0",
                  .version = "1.0.0",
                  .extensions = ".gltf"}) {}
  void exportScene(sdk::Host& host, sdk::SceneView& scene, sdk::Writer& writer) override {
    Document document = documentOf(host, scene);
    const std::vector<std::uint8_t>& buffer = document.buffer();
    const std::string name = contentName(buffer) + ".bin";
    if (!buffer.empty()) writer.writeBeside(name, buffer.data(), buffer.size());
    const std::string text = document.text(name);
    writer.write(text.data(), text.size());
  }
};

class Glb final : public sdk::Exporter {
 public:
  Glb()
      : Exporter({.id = "org.steradian.glb_export",
                  .name = "glTF 2.0 binary",
                  .version = "1.0.0",
                  .extensions = ".glb"}) {}
  void exportScene(sdk::Host& host, sdk::SceneView& scene, sdk::Writer& writer) override {
    Document document = documentOf(host, scene);
    std::string json = document.text("");
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string binary(document.buffer().begin(), document.buffer().end());
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const std::size_t chunks = 12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size());
    if (chunks > UINT32_MAX) throw sdk::BadInput("the scene needs more than 4 GiB; save it as .gltf");
    const auto word = [&](std::size_t value) {
      const auto v = std::uint32_t(value);
      writer.write(&v, 4);
    };
    word(0x46546C67), word(2), word(chunks);  // "glTF"
    word(json.size()), word(0x4E4F534A);      // "JSON"
    writer.write(json.data(), json.size());
    if (binary.empty()) return;
    word(binary.size()), word(0x004E4942);  // "BIN"
    writer.write(binary.data(), binary.size());
  }
};

}  // namespace

}  // namespace gltf_export

STERADIAN_PLUGIN(registry) {
  registry.add<gltf_export::Gltf>();
  registry.add<gltf_export::Glb>();
}
