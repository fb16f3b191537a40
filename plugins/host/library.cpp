// SPDX-License-Identifier: MIT
// One plugin file opened in this process.
#include "plugins/host/library.hpp"

#include <dlfcn.h>

#include <stdexcept>

#include "plugins/host/elf_check.hpp"

namespace steradian::plugins {

namespace {

class Collector final : public sdk::RegistryInterface {
 public:
  explicit Collector(Library& library) : library_(library) {}
  void addImporter(sdk::ImporterInterface& importer) noexcept override {
    library_.importers.push_back(&importer);
  }
  void addExporter(sdk::ExporterInterface& exporter) noexcept override {
    library_.exporters.push_back(&exporter);
  }

 private:
  Library& library_;
};

}  // namespace

Library openLibrary(const std::filesystem::path& file) {
  void* handle = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error(dlerror());
  const auto* entry = static_cast<const sdk::PluginEntry*>(dlsym(handle, "steradian_plugin"));
  if (!entry) throw std::runtime_error("has no symbol steradian_plugin");
  const std::string mismatch = interfaceMismatch(entry->magic, entry->major, entry->minor, entry->size);
  if (!mismatch.empty()) throw std::runtime_error(mismatch);
  Library library;
  Collector collector(library);
  if (!entry->load || entry->load(collector) != sdk::Status::ok)
    throw std::runtime_error("could not initialise: its registration failed");
  return library;
}

}  // namespace steradian::plugins
