// SPDX-License-Identifier: MIT
// glTF 2.0 (.gltf, .glb) as a plugin: an importer. README.md says what becomes what.
#include "container.hpp"
#include "open.hpp"
#include "scene_writer.hpp"

namespace {

namespace sdk = steradian::sdk;

constexpr sdk::ParameterInfo kParameters[] = {
    {.id = "scene",
     .name = "Scene",
     .help = "Which scene of the file; -1 = its default",
     .type = sdk::ParameterType::integer,
     .defaultValue = -1,
     .minimum = -1,
     .maximum = 1e6},
    {.id = "animation",
     .name = "Animation",
     .help = "Which animation; -1 = all, the first that moves a node counts",
     .type = sdk::ParameterType::integer,
     .defaultValue = -1,
     .minimum = -1,
     .maximum = 1e6},
    {.id = "time",
     .name = "Time",
     .unit = "s",
     .help = "When skins and morph targets are baked",
     .type = sdk::ParameterType::real,
     .defaultValue = 0,
     .minimum = 0,
     .maximum = 1e6}};

constexpr sdk::FormatInfo kFormat = {.id = "org.steradian.gltf",
                                     .name = "glTF 2.0",
                                     .version = "1.0.0",
                                     .extensions = ".gltf .glb",
                                     .maxBytes = 4ull << 30,
                                     .parameterCount = std::size(kParameters),
                                     .parameters = kParameters};

class GltfImporter final : public sdk::Importer {
 public:
  GltfImporter() : Importer(kFormat) {}
  std::uint32_t probe(sdk::Text head) noexcept override {
    if (head.view().substr(0, 4) == "glTF") return 100;
    return head.view().find("\"asset\"") != std::string_view::npos ? 60 : 0;
  }
  void import(sdk::Host& host, std::string_view bytes, sdk::SceneSink& sink) override {
    const gltf::Document document = gltf::openDocument(host, bytes);
    gltf::Report report(host);
    gltf::SceneWriter(document, report, host, sink)
        .write({int(host.parameter("scene")), int(host.parameter("animation")), host.parameter("time")});
  }
};

}  // namespace

STERADIAN_PLUGIN(registry) {
  registry.add<GltfImporter>();
}
