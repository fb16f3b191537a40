// SPDX-License-Identifier: MIT
// Reading skies and textures, and naming them relative to the project.
#include "editor/assets.hpp"

#include <algorithm>
#include <cmath>

#include "editor/image_file.hpp"
#include "renderer/scene/error.hpp"

namespace steradian {

namespace fs = std::filesystem;

namespace {

constexpr float kLargestHalf = 65504.0f;  // what an overflowed sun in a half-float EXR meant at least

/// The first three channels, or the only one thrice.
Image threeChannels(const Image& source) {
  Image out{source.width, source.height, 3, {}};
  const std::size_t pixels = std::size_t(source.width) * source.height;
  out.pixels.resize(pixels * 3);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      out.pixels[i * 3 + c] = source.pixels[i * source.channels + (source.channels < 3 ? 0 : c)];
  return out;
}

/// Makes every value finite and >= 0; how many were not.
std::size_t sanitize(Image& image) {
  std::size_t bad = 0;
  for (float& value : image.pixels) {
    if (std::isfinite(value) && value >= 0.0f) continue;
    value = value > 0.0f ? kLargestHalf : 0.0f;  // NaN compares false
    ++bad;
  }
  return bad;
}

Image readSky(const fs::path& file, std::vector<AssetProblem>& problems) {
  const ImageFile read = readImage(file);
  if (read.format == "png" || read.format == "jpeg")
    throw Error(ExitCode::badInput,
                file.string() + ": is a PNG or JPEG, whose range ends at white; give the sky as EXR or HDR");
  Image sky = threeChannels(read.image);
  if (const std::size_t bad = sanitize(sky))
    problems.push_back({file.string() + ": " + std::to_string(bad) +
                        " values were negative, infinite or not a number; they count as 0 or 65504"});
  return sky;
}

EnvironmentLight* environmentOf(Object& object) {
  Light* light = std::get_if<Light>(&object.content);
  return light ? std::get_if<EnvironmentLight>(&light->kind) : nullptr;
}

std::string nameOf(const Object& object) {
  return object.name.empty() ? std::string("#") + std::to_string(unsigned(object.id)) : object.name;
}

}  // namespace

std::shared_ptr<const Image> Assets::image(const fs::path& file, std::vector<AssetProblem>& problems) {
  std::error_code none;
  const fs::file_time_type time = fs::last_write_time(file, none);
  const std::uintmax_t size = none ? 0 : fs::file_size(file, none);
  Loaded& loaded = loaded_[file];
  if (!none && loaded.time == time && loaded.size == size)
    if (auto present = loaded.image.lock()) return present;
  auto fresh = std::make_shared<const Image>(readSky(file, problems));
  loaded = {time, size, fresh};
  return fresh;
}

void Assets::loadSkies(Scene& scene, const fs::path& projectFolder, std::vector<AssetProblem>& problems) {
  for (Object& object : scene.objects) {
    EnvironmentLight* sky = environmentOf(object);
    if (!sky) continue;
    sky->image = nullptr;
    if (sky->file.empty()) continue;
    try {
      sky->image = image(fs::absolute(projectFolder / sky->file).lexically_normal(), problems);
    } catch (const std::exception& error) {
      problems.push_back(
          {std::string(error.what()) + "; put the file there, or choose another for '" + nameOf(object) + "'",
           true});
    }
  }
}

std::vector<AssetProblem> Assets::load(Scene& scene, const fs::path& projectFolder) {
  std::vector<AssetProblem> problems;
  loadSkies(scene, projectFolder, problems);
  for (std::string& message : textures_.load(scene, projectFolder)) problems.push_back({std::move(message)});
  return problems;
}

std::vector<std::string> loadAssets(Scene& scene, const fs::path& projectFolder) {
  std::vector<std::string> warnings;
  for (AssetProblem& problem : Assets().load(scene, projectFolder)) {
    if (problem.missing) throw Error(ExitCode::badInput, problem.message);
    warnings.push_back(std::move(problem.message));
  }
  return warnings;
}

fs::path projectFolderOf(const fs::path& project) {
  std::error_code ignored;
  return fs::is_directory(project, ignored) ? project : project.parent_path();
}

std::string assetName(const fs::path& file, const fs::path& projectFolder) {
  const fs::path absolute = fs::absolute(file).lexically_normal();
  if (projectFolder.empty()) return absolute.string();
  const fs::path relative =
      absolute.lexically_relative(fs::absolute(projectFolder / "").lexically_normal().parent_path());
  return relative.empty() || *relative.begin() == ".." ? absolute.string() : relative.string();
}

Scene withAssetsNamedFrom(Scene scene, const fs::path& oldFolder, const fs::path& newFolder) {
  for (Object& object : scene.objects)
    if (EnvironmentLight* sky = environmentOf(object); sky && !sky->file.empty())
      sky->file = assetName(oldFolder / sky->file, newFolder);
  renameTextures(scene, [&](const std::string& file) { return assetName(oldFolder / file, newFolder); });
  return scene;
}

}  // namespace steradian
