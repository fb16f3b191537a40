// SPDX-License-Identifier: MIT
// An importer and exporter built against the frozen headers of interface 1.0.
#include <cstring>
#include <steradian/plugin.hpp>

namespace sdk = steradian::sdk;

static_assert(sdk::kMinor == 0 && sizeof(sdk::MaterialRecord) == 88, "not the frozen headers");

namespace {

constexpr sdk::FormatInfo kFormat = {
    .id = "org.example.old", .name = "Old", .version = "1.0.0", .extensions = ".old"};

class OldImporter final : public sdk::Importer {
 public:
  OldImporter() : Importer(kFormat) {}
  void import(sdk::Host&, std::string_view, sdk::SceneSink& sink) override {
    sink.setRender({.width = 7, .height = 8, .seed = 9});
    sink.setDisplay({.exposure = 2});
    sdk::MaterialRecord red{.id = 1, .name = "Red", .roughness = 0.25f, .emissionLuminance = 3};
    std::memset(reinterpret_cast<char*>(&red) + 84, 0xff, 4);  // padding holds anything
    sink.addMaterial(red);
    sink.addObject({.id = 2, .kind = sdk::ObjectKind::sphere, .material = 1, .name = "Ball", .radius = 3});
    sink.addObject({.id = 3, .kind = sdk::ObjectKind::camera, .fovY = 0.5});
    sink.addObject({.id = 4, .kind = sdk::ObjectKind::spotLight, .intensity = 5, .outerConeAngle = 0.5f});
    sink.addObject({.id = 5, .kind = sdk::ObjectKind::directionalLight, .intensity = 6});
  }
};

/// Writes "kind name" of each object; what is newer than 1.0 is reported, as every exporter should.
class OldExporter final : public sdk::Exporter {
 public:
  OldExporter() : Exporter(kFormat) {}
  void exportScene(sdk::Host& host, sdk::SceneView& view, sdk::Writer& writer) override {
    std::string text = std::to_string(view.render().seed) + "\n";
    for (std::uint64_t i = 0; i < view.objectCount(); ++i) {
      const sdk::ObjectRecord object = sdk::adopt(view.object(i));
      text += std::to_string(unsigned(object.kind)) + " " + object.name.str() + "\n";
      if (object.kind > sdk::ObjectKind::camera) host.notKept(object.name, "is of an unknown kind");
    }
    for (std::uint64_t i = 0; i < view.materialCount(); ++i)
      text += std::to_string(sdk::adopt(view.material(i)).roughness) + "\n";
    writer.write(text.data(), text.size());
  }
};

}  // namespace

STERADIAN_PLUGIN(registry) {
  registry.add<OldImporter>();
  registry.add<OldExporter>();
}
