// SPDX-License-Identifier: MIT
// The whole plugin contract: the C-safe border first, the C++ layer for authors after it.
//
//   class Obj : public steradian::sdk::Importer { ... };
//   STERADIAN_PLUGIN(registry) { registry.add<Obj>(); }
//
// Across the border go only plain records, UTF-8 text with a length and pure-virtual interfaces that grow at
// the end; no std:: container, no exception, no ownership of memory. Interfaces are never deleted by the
// other side. Threads: the host calls one object from one thread at a time, never from two at once; it may be
// a worker thread.
#pragma once
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>

#include <steradian/image.hpp>
#include <steradian/records.hpp>

namespace steradian::sdk {

/// Services of the host during one call. Any thread of the plugin, until the call returns. None of them
/// fails.
class Host {
 public:
  virtual void log(Text message) noexcept = 0;          // shown to the user; the host copies the text
  virtual void progress(double fraction) noexcept = 0;  // 0..1
  virtual bool cancelled() noexcept = 0;                // true: return Status::cancelled soon
  virtual void fail(Text message) noexcept = 0;  // the reason for badInput or failed: place, cause, remedy
  virtual double parameter(
      Text id) noexcept = 0;  // the user's value within its range, else the default; unknown: 0
  virtual void notKept(Text what, Text why) noexcept = 0;  // for the import report: approximated or dropped
  // since 1.2
  /// A file inside the folder of the imported file, by a relative path; the bytes live until the call
  /// returns. Refused with a reason in `bytes` and the answer false: paths that lead out, what is no regular
  /// file, what is too large.
  virtual bool readBeside(Text path, Text& bytes) noexcept = 0;
};

/// Receives an imported scene. Only from the thread of the call. The host copies everything, validates it as
/// a whole when the importer returns ok, and then takes it as one undo step, or nothing.
class SceneSink {
 public:
  virtual void setScene(const SceneRecord& scene) noexcept = 0;
  virtual void setRender(const RenderSettingsRecord& settings) noexcept = 0;
  virtual void setDisplay(const DisplaySettingsRecord& settings) noexcept = 0;
  virtual void addMaterial(const MaterialRecord& material) noexcept = 0;
  virtual void addObject(const ObjectRecord& object) noexcept = 0;
  virtual void addChannel(const ChannelRecord& channel) noexcept = 0;
  // since 1.2
  virtual void addMesh(const MeshRecord& mesh) noexcept = 0;
  virtual void addTexture(const TextureRecord& texture) noexcept = 0;
};

/// The scene to export. Any thread. Everything is owned by the host and lives until the call returns.
class SceneView {
 public:
  virtual const SceneRecord& scene() noexcept = 0;
  virtual const RenderSettingsRecord& render() noexcept = 0;
  virtual const DisplaySettingsRecord& display() noexcept = 0;
  virtual std::uint64_t materialCount() noexcept = 0;
  virtual const MaterialRecord& material(std::uint64_t index) noexcept = 0;  // index < materialCount()
  virtual std::uint64_t objectCount() noexcept = 0;
  virtual const ObjectRecord& object(std::uint64_t index) noexcept = 0;
  virtual std::uint64_t channelCount() noexcept = 0;
  virtual const ChannelRecord& channel(std::uint64_t index) noexcept = 0;
  // since 1.2; ids are 1 + index
  virtual std::uint64_t meshCount() noexcept = 0;
  virtual const MeshRecord& mesh(std::uint64_t index) noexcept = 0;
  virtual std::uint64_t textureCount() noexcept = 0;
  virtual const TextureRecord& texture(std::uint64_t index) noexcept = 0;
};

/// Receives the bytes of the exported file in order; the host copies them and writes the file atomically at
/// the end.
class Writer {
 public:
  virtual void write(const void* data, std::uint64_t size) noexcept = 0;
  // since 1.2
  /// A file beside the exported one, by a relative path such as "NAME.assets/3f2a.mesh"; written before it.
  virtual void writeBeside(Text path, const void* data, std::uint64_t size) noexcept = 0;
  /// The stem of the exported file's name: "room" of "room.srad".
  virtual Text stem() noexcept = 0;
};

/// An importer as the host sees it. Errors by Status; the reason through Host::fail. No exception leaves.
class ImporterInterface {
 public:
  virtual const FormatInfo& info() noexcept = 0;
  virtual std::uint32_t probe(
      Text head) noexcept = 0;  // the first 4 KiB: 0 = not mine ... 100 = certainly mine
  virtual Status run(Host& host, const SourceFile& file, SceneSink& sink) noexcept = 0;
};

/// An exporter as the host sees it; exactly one of scene and image is not null, by info().takesImage.
class ExporterInterface {
 public:
  virtual const FormatInfo& info() noexcept = 0;
  virtual Status run(Host& host, SceneView* scene, const ImageRecord* image, Writer& writer) noexcept = 0;
};

/// Where a plugin announces what it has, once, while it is loaded. The objects live until the process ends.
class RegistryInterface {
 public:
  virtual void addImporter(ImporterInterface& importer) noexcept = 0;
  virtual void addExporter(ExporterInterface& exporter) noexcept = 0;
};

/// The one exported symbol `steradian_plugin`. `load` runs on the host's start-up thread and returns badly
/// only by Status; the same numbers stand in the ELF note, so a host reads them before any code of the plugin
/// runs.
struct PluginEntry {
  std::uint32_t magic = kMagic, major = kMajor, minor = kMinor, size = sizeof(PluginEntry);
  Status (*load)(RegistryInterface& registry) noexcept = nullptr;
};

/// The ELF note ".note.steradian": name "STRD", type 1.
struct VersionNote {
  std::uint32_t nameSize = 5, contentSize = 16, type = 1;
  char name[8] = {'S', 'T', 'R', 'D', 0, 0, 0, 0};
  std::uint32_t magic = kMagic, major = kMajor, minor = kMinor, entrySize = sizeof(PluginEntry);
};

// ---- The C++ layer. Nothing below crosses the border, and no symbol of it is shared between plugins.

/// Throw it when the file is at fault; any other exception is taken for a fault of the plugin.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct Cancelled {};  // throw it after Host::cancelled() said yes

/// Runs `work` and turns every exception into a Status and a message for the host.
template <class Work>
Status guarded(Host& host, Work&& work) noexcept try {
  work();
  return Status::ok;
} catch (const Cancelled&) {
  return Status::cancelled;
} catch (const BadInput& error) {
  host.fail(error.what());
  return Status::badInput;
} catch (const std::exception& error) {
  host.fail(error.what());
  return Status::failed;
} catch (...) {
  host.fail("threw an exception that is not a std::exception");
  return Status::failed;
}

/// Derive, describe yourself in the constructor, push records into the sink. May throw.
class Importer : public ImporterInterface {
 public:
  explicit Importer(const FormatInfo& info) : info_(info) {}
  const FormatInfo& info() noexcept final { return info_; }
  std::uint32_t probe(Text) noexcept override { return 0; }
  Status run(Host& host, const SourceFile& file, SceneSink& sink) noexcept final {
    return guarded(host, [&] { import(host, {file.bytes, file.byteCount}, sink); });
  }
  virtual void import(Host& host, std::string_view bytes, SceneSink& sink) = 0;

 private:
  FormatInfo info_;
};

/// Derive and override the one that takesImage names. May throw.
class Exporter : public ExporterInterface {
 public:
  explicit Exporter(const FormatInfo& info) : info_(info) {}
  const FormatInfo& info() noexcept final { return info_; }
  Status run(Host& host, SceneView* scene, const ImageRecord* image, Writer& writer) noexcept final {
    return guarded(
        host, [&] { image ? exportImage(host, adopt(*image), writer) : exportScene(host, *scene, writer); });
  }
  virtual void exportScene(Host&, SceneView&, Writer&) { throw std::logic_error("does not take scenes"); }
  virtual void exportImage(Host&, const ImageRecord&, Writer&) {
    throw std::logic_error("does not take images");
  }

 private:
  FormatInfo info_;
};

/// What STERADIAN_PLUGIN's body receives.
class __attribute__((visibility("hidden"))) Registry {
 public:
  explicit Registry(RegistryInterface& host) : host_(host) {}
  template <class Contribution>
  void add() {
    static Contribution contribution;
    if constexpr (std::is_base_of_v<ImporterInterface, Contribution>)
      host_.addImporter(contribution);
    else
      host_.addExporter(contribution);
  }

 private:
  RegistryInterface& host_;
};

}  // namespace steradian::sdk

/// Once per plugin: STERADIAN_PLUGIN(registry) { registry.add<MyImporter>(); }
#define STERADIAN_PLUGIN(registry)                                                                        \
  static void steradianRegister(::steradian::sdk::Registry& registry);                                    \
  static ::steradian::sdk::Status steradianLoad(::steradian::sdk::RegistryInterface& host) noexcept try { \
    ::steradian::sdk::Registry own(host);                                                                 \
    steradianRegister(own);                                                                               \
    return ::steradian::sdk::Status::ok;                                                                  \
  } catch (...) {                                                                                         \
    return ::steradian::sdk::Status::failed;                                                              \
  }                                                                                                       \
  __attribute__((section(".note.steradian"), used,                                                        \
                 aligned(4))) static const ::steradian::sdk::VersionNote steradianNote;                   \
  extern "C" __attribute__((visibility("default")))                                                       \
  const ::steradian::sdk::PluginEntry steradian_plugin = {.load = steradianLoad};                         \
  static void steradianRegister(::steradian::sdk::Registry& registry)
