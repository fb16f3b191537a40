// SPDX-License-Identifier: MIT
// Wavefront OBJ with its material libraries (MTL), as a plugin: polygons, groups, materials, textures, vertex
// colours.
#include "model.hpp"

namespace {

namespace sdk = steradian::sdk;

class ObjImporter final : public sdk::Importer {
 public:
  ObjImporter()
      : Importer(
            {.id = "org.steradian.obj", .name = "Wavefront OBJ", .version = "1.0.0", .extensions = ".obj"}) {}
  std::uint32_t probe(sdk::Text head) noexcept override {
    const std::string_view text = head.view();
    return text.find("\nv ") != text.npos || text.find("\nmtllib ") != text.npos || text.starts_with("v ")
               ? 40
               : 0;
  }
  void import(sdk::Host& host, std::string_view bytes, sdk::SceneSink& sink) override {
    obj::Model model = obj::parseModel(host, bytes);
    obj::build(host, model, "Mesh", sink);
  }
};

}  // namespace

STERADIAN_PLUGIN(registry) {
  registry.add<ObjImporter>();
}
