// SPDX-License-Identifier: MIT
// The files that a scene names: skies are read into their environment lights, textures into materials.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "editor/textures.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian {

/// One file that could not be used, or not as it is: file, cause and remedy.
struct AssetProblem {
  std::string message;
  bool missing = false;  // a sky of which nothing was loaded: commands refuse the scene
};

/// Reads the files of scenes. One thread at a time.
class Assets {
 public:
  /// Fills EnvironmentLight::image for every light that names a file: 3 channels of finite values >= 0. A
  /// file that is unchanged (time and size) and whose pixels some scene still holds keeps its pointer, so
  /// equal scenes stay equal. A light whose file cannot be used shows its gradient alone. Materials get
  /// textures with pixels (see Textures).
  std::vector<AssetProblem> load(Scene& scene, const std::filesystem::path& projectFolder);
  /// One sky. Throws Error(badInput | io).
  std::shared_ptr<const Image> image(const std::filesystem::path& file, std::vector<AssetProblem>& problems);

 private:
  struct Loaded {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    std::weak_ptr<const Image> image;
  };
  void loadSkies(Scene& scene, const std::filesystem::path& projectFolder,
                 std::vector<AssetProblem>& problems);

  std::map<std::filesystem::path, Loaded> loaded_;
  Textures textures_;
};

/// For commands: throws Error(badInput) when a sky is missing, returns what is only worth a warning.
std::vector<std::string> loadAssets(Scene& scene, const std::filesystem::path& projectFolder);

/// The folder that the files of a project are relative to; `project` may be the folder itself.
std::filesystem::path projectFolderOf(const std::filesystem::path& project);
/// How a project in `projectFolder` names `file`: relative when it lies inside it, else absolute.
std::string assetName(const std::filesystem::path& file, const std::filesystem::path& projectFolder);
/// The same files named from another folder, for a project that is saved elsewhere; an empty folder stands
/// for a project without a place yet.
Scene withAssetsNamedFrom(Scene scene, const std::filesystem::path& oldFolder,
                          const std::filesystem::path& newFolder);

}  // namespace steradian
