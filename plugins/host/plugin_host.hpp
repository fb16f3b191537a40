// SPDX-License-Identifier: MIT
// Finds, checks and loads plugins; turns what importers push into a Scene, and scenes into what exporters
// read.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "renderer/scene/error.hpp"
#include "renderer/scene/image.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian::plugins {

enum class Kind { importer, exporter, tonemapper };

/// A parameter as data: the host draws it, stores it and offers it as `--param id=value`.
struct Parameter {
  enum class Type { real, integer, boolean };
  std::string id, name, unit, help;
  Type type = Type::real;
  double defaultValue = 0.0, minimum = 0.0, maximum = 1.0;
};

/// One contribution of one plugin file.
struct Contribution {
  Kind kind;
  std::string id, name;                         // "org.steradian.exr", "OpenEXR"
  std::string version;                          // of the plugin
  std::vector<std::string> extensions;          // ".exr"; importers and exporters
  bool takesScene = false, takesImage = false;  // exporters
  std::vector<Parameter> parameters;
  std::string glsl;  // tonemappers
};

/// One file in a plugin folder: loaded, or the reason why not.
struct PluginFile {
  std::filesystem::path path;
  bool loaded = false;
  std::string reason;  // "built for interface 2.0, this host speaks 1.0", dlerror text ...
  std::vector<Contribution> contributions;
};

using Parameters = std::map<std::string, double>;

struct Progress {
  std::function<void(double fraction)> report;  // 0..1, may be empty
  std::function<bool()> cancelled;              // may be empty
  std::function<void(const std::string&)> log;  // warnings and notes, may be empty
};

/// What an import could not keep, by name.
struct ImportReport {
  struct Line {
    std::string what, why;
  };
  std::vector<Line> notKept;
};

struct ImportResult {
  Scene scene;
  ImportReport report;
};

/// More channels of a picture, for formats that hold layers (EXR): NAME.R, NAME.G ... in the file.
struct ImageLayer {
  std::string name;                       // "albedo"
  Image pixels;                           // of the picture's size
  std::vector<std::string> channelNames;  // one for each channel of pixels: "R", "G", "B", "Z", "id" ...
  bool operator==(const ImageLayer&) const = default;
};

/// Float pixels offered to an image exporter, with text metadata (EXR attributes, PNG text).
struct ImageToSave {
  int width = 0, height = 0;
  const float* radiance = nullptr;   // scene-linear RGB, 3 floats per pixel; for scene-linear formats
  const float* displayed = nullptr;  // display-encoded RGB in [0, 1]; for display formats
  std::map<std::string, std::string> metadata;
  std::span<const ImageLayer> layers = {};  // left out by formats that hold none
};

class PluginHost {
 public:
  /// Loads every plugin found along `searchPath` in deterministic order; bad ones are listed, never fatal.
  explicit PluginHost(const std::vector<std::filesystem::path>& searchPath);
  ~PluginHost();

  std::span<const PluginFile> files() const;
  std::vector<const Contribution*> contributions(Kind kind) const;
  const Contribution* tonemapper(
      std::string_view id) const;  // nullptr when absent; also finds by the id's last word
  const Contribution* exporterFor(const std::filesystem::path& path, bool image) const;
  bool canImport(const std::filesystem::path& path) const;

  /// Validated as a whole or not at all. A folder means its one .srad.
  /// Throws Error(badInput | plugin | io) naming file, place, cause and remedy.
  ImportResult importScene(const std::filesystem::path& path, const Progress& = {},
                           const Parameters& = {}) const;
  /// Atomic: temporary file, fsync, rename, fsync of the folder. Throws Error(io | plugin); the old file
  /// stays.
  void exportScene(const Scene& scene, const std::filesystem::path& path, const Progress& = {},
                   const Parameters& = {}) const;
  void exportImage(const ImageToSave& image, const std::filesystem::path& path, const Progress& = {},
                   const Parameters& = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// `--plugin-path` entries, $STERADIAN_PLUGIN_PATH, $XDG_DATA_HOME/steradian/plugins, the installed folder.
std::vector<std::filesystem::path> defaultSearchPath(const std::vector<std::filesystem::path>& extra = {});

}  // namespace steradian::plugins
