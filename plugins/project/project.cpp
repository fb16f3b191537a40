// SPDX-License-Identifier: MIT
// The project file (.srad) as a plugin: one importer, one exporter. README.md describes the format.
#include "project.hpp"

#include "json_text.hpp"

namespace {

namespace sdk = steradian::sdk;

constexpr sdk::FormatInfo kFormat = {.id = "org.steradian.project",
                                     .name = "Steradian project",
                                     .version = "1.0.0",
                                     .extensions = ".srad",
                                     .maxBytes = project::kLargest};

class ProjectImporter final : public sdk::Importer {
 public:
  ProjectImporter() : Importer(kFormat) {}
  std::uint32_t probe(sdk::Text head) noexcept override {
    return head.view().find("\"steradian\"") != std::string_view::npos ? 90 : 0;
  }
  void import(sdk::Host& host, std::string_view bytes, sdk::SceneSink& sink) override {
    project::readProject(host, bytes, sink);
  }
};

class ProjectExporter final : public sdk::Exporter {
 public:
  ProjectExporter() : Exporter(kFormat) {}
  void exportScene(sdk::Host& host, sdk::SceneView& view, sdk::Writer& writer) override {
    project::writeProject(host, view, writer);
  }
};

}  // namespace

STERADIAN_PLUGIN(registry) {
  registry.add<ProjectImporter>();
  registry.add<ProjectExporter>();
}
