// SPDX-License-Identifier: MIT
// Opening and saving documents through the plugins, with messages instead of exceptions.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/assets.hpp"
#include "editor/document.hpp"
#include "editor/edits.hpp"
#include "editor/recent_files.hpp"
#include "editor/ui/loading.hpp"
#include "editor/ui/messages.hpp"
#include "plugins/host/plugin_host.hpp"

namespace steradian::ui {

/// The environment light that is shown; none when there is none.
Id skyOf(const Scene& scene);

/// What is to be told of a file when a document takes it.
struct Remark {
  Messages::Kind kind;
  std::string text;
};
/// A file as it was read, before a document takes it.
struct ReadScene {
  std::filesystem::path path;  // absolute
  Scene scene;
  std::vector<Remark> remarks;
};
struct ReadSky {
  std::filesystem::path path;  // absolute
  std::shared_ptr<const Image> image;
  std::vector<Remark> remarks;
};

/// What reads belongs to one thread at a time, which may be a worker; the rest to the frame loop's.
class ProjectFiles {
 public:
  ProjectFiles(const plugins::PluginHost& plugins, Messages& messages)
      : plugins_(plugins), messages_(messages) {}

  /// The scene with its images, to be opened, or with `into` to be taken into the project in that folder: its
  /// files are then named from there. Throws what importScene throws; cancelling is an error, too.
  ReadScene read(const std::filesystem::path& path, LoadStatus& status,
                 const std::optional<std::filesystem::path>& into = {});
  /// Throws Error(badInput | io).
  ReadSky readSky(const std::filesystem::path& path);

  /// A document of what was read: the project itself, or a new one when it cannot be written back.
  Document open(ReadScene read);
  /// The open scene with the file's objects in it.
  edits::Merged import(const Document& document, const ReadScene& read);
  /// The scene with the image on this environment light, or on a new one when there is none; nullopt, with a
  /// message, when the light is gone.
  std::optional<Scene> withSky(const Document& document, Id light, const ReadSky& read);
  /// A message, and the file leaves the list of recent ones.
  void failed(const std::filesystem::path& path, const std::string& reason);

  /// False, with a message, when it cannot be written; the old file stays and the document stays unsaved.
  bool save(Document& document, const std::filesystem::path& path);
  /// After a fault that ends the program: a copy in the state folder. The path, when it could be written.
  std::optional<std::filesystem::path> rescue(const Document& document);

  bool isProject(const std::filesystem::path& path) const;  // opened rather than added
  bool isSky(const std::filesystem::path& path) const;
  std::vector<std::string> importExtensions() const;
  std::vector<std::string> addExtensions() const;  // of models and skies
  std::vector<std::string> saveExtensions() const;
  const RecentFiles& recent() const { return recent_; }

 private:
  void tell(const std::vector<Remark>& remarks);

  const plugins::PluginHost& plugins_;
  Messages& messages_;
  RecentFiles recent_;
  Assets assets_;
};

}  // namespace steradian::ui
