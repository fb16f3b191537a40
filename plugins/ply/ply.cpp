// SPDX-License-Identifier: MIT
// The polygon file format (PLY, Turk 1994) as a plugin: text and binary, normals, texture coordinates,
// colours.
#include "build_ply.hpp"

namespace {

namespace sdk = steradian::sdk;

class PlyImporter final : public sdk::Importer {
 public:
  PlyImporter()
      : Importer({.id = "org.steradian.ply",
                  .name = "Polygon file (PLY)",
                  .version = "1.0.0",
                  .extensions = ".ply"}) {}
  std::uint32_t probe(sdk::Text head) noexcept override { return head.view().starts_with("ply") ? 80 : 0; }
  void import(sdk::Host& host, std::string_view bytes, sdk::SceneSink& sink) override {
    const ply::Header header = ply::parseHeader(bytes);
    ply::Values values(header, bytes);
    ply::Builder builder(host);
    builder.read(header, values);
    builder.push(sink);
  }
};

}  // namespace

STERADIAN_PLUGIN(registry) {
  registry.add<PlyImporter>();
}
