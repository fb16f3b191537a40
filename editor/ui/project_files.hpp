// SPDX-License-Identifier: MIT
// Opening and saving documents through the plugins, with messages instead of exceptions.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/assets.hpp"
#include "editor/document.hpp"
#include "editor/recent_files.hpp"
#include "editor/ui/messages.hpp"
#include "plugins/host/plugin_host.hpp"

namespace steradian::ui {

class ProjectFiles {
 public:
  ProjectFiles(const plugins::PluginHost& plugins, Messages& messages)
      : plugins_(plugins), messages_(messages) {}

  /// nullopt, with a message, when it cannot be read; nothing else changes then.
  std::optional<Document> load(const std::filesystem::path& path);
  /// The scene with `image` on this environment light; nullopt, with a message, when it cannot be read.
  std::optional<Scene> withSky(const Document& document, Id light, const std::filesystem::path& image);
  /// False, with a message, when it cannot be written; the old file stays and the document stays unsaved.
  bool save(Document& document, const std::filesystem::path& path);
  /// After a fault that ends the program: a copy in the state folder. The path, when it could be written.
  std::optional<std::filesystem::path> rescue(const Document& document);

  std::vector<std::string> importExtensions() const;
  std::vector<std::string> saveExtensions() const;
  const RecentFiles& recent() const { return recent_; }

 private:
  /// Reads the images that the scene names; what is missing becomes a message.
  void loadAssets(Scene& scene, const std::filesystem::path& folder);

  const plugins::PluginHost& plugins_;
  Messages& messages_;
  RecentFiles recent_;
  Assets assets_;
};

}  // namespace steradian::ui
