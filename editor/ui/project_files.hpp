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
#include "editor/ui/messages.hpp"
#include "plugins/host/plugin_host.hpp"

namespace steradian::ui {

/// The environment light that is shown; none when there is none.
Id skyOf(const Scene& scene);

class ProjectFiles {
 public:
  ProjectFiles(const plugins::PluginHost& plugins, Messages& messages)
      : plugins_(plugins), messages_(messages) {}

  /// nullopt, with a message, when it cannot be read; nothing else changes then.
  std::optional<Document> load(const std::filesystem::path& path);
  /// The open scene with the file's objects in it; nullopt, with a message, when it cannot be read.
  std::optional<edits::Merged> import(const Document& document, const std::filesystem::path& path);
  /// The scene with `image` on this environment light, or on a new one when there is none; nullopt, with a
  /// message, when it cannot be read.
  std::optional<Scene> withSky(const Document& document, Id light, const std::filesystem::path& image);
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
  /// The scene and its images; what is missing or not kept becomes a message. Throws what importScene throws.
  Scene read(const std::filesystem::path& path);

  const plugins::PluginHost& plugins_;
  Messages& messages_;
  RecentFiles recent_;
  Assets assets_;
};

}  // namespace steradian::ui
