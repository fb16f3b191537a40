// SPDX-License-Identifier: MIT
// libFuzzer over the glTF importer, without the border: any bytes are imported or refused with a reason, and
// what is imported is a sound scene.
#include <cstdio>
#include <cstdlib>
#include <deque>

#include "plugins/host/scene_builder.hpp"

extern "C" const steradian::sdk::PluginEntry steradian_plugin;

namespace {

namespace sdk = steradian::sdk;

/// No files, all parameters at their usual values; remembers the reason of a refusal.
class FuzzHost final : public sdk::Host {
 public:
  void log(sdk::Text) noexcept override {}
  void progress(double) noexcept override {}
  bool cancelled() noexcept override { return false; }
  void fail(sdk::Text message) noexcept override { reason = message.str(); }
  double parameter(sdk::Text id) noexcept override { return id.view() == "time" ? 0.5 : -1.0; }
  void notKept(sdk::Text, sdk::Text) noexcept override {}
  bool readBeside(sdk::Text, sdk::Text& bytes) noexcept override {
    bytes = "no files here";
    return false;
  }
  std::string reason;
};

class Registry final : public sdk::RegistryInterface {
 public:
  void addImporter(sdk::ImporterInterface& found) noexcept override { importer = &found; }
  void addExporter(sdk::ExporterInterface&) noexcept override {}
  sdk::ImporterInterface* importer = nullptr;
};

[[noreturn]] void fail(const char* what, const std::string& detail) {
  std::fprintf(stderr, "%s: %s\n", what, detail.c_str());
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Registry registry;
  if (!registry.importer && steradian_plugin.load(registry) != sdk::Status::ok)
    fail("plugin", "does not load");
  FuzzHost host;
  steradian::plugins::SceneBuilder sink;
  sdk::SourceFile file;
  file.bytes = reinterpret_cast<const char*>(data);
  file.byteCount = size;
  const sdk::Status status = registry.importer->run(host, file, sink);
  if (status == sdk::Status::badInput && host.reason.empty()) fail("refused without a reason", "");
  if (status == sdk::Status::badInput) return 0;
  if (status != sdk::Status::ok) fail("failed", host.reason);
  std::vector<steradian::Problem> problems;
  sink.finish(problems);
  if (!problems.empty()) fail("pushed an unsound scene", problems[0].where + " " + problems[0].what);
  return 0;
}
