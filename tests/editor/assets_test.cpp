// SPDX-License-Identifier: MIT
// Skies are found beside the project, keep their identity, and are told apart from what is no sky.
#include "editor/assets.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "editor/image_file.hpp"
#include "renderer/scene/error.hpp"
#include "tests/temporary_folder.hpp"

namespace steradian {
namespace {

namespace fs = std::filesystem;

class AssetsTest : public TemporaryFolder {
 protected:
  /// Two pixels, the left (1, 0.5, 0.25), the right 2^`exponent` in all channels, as flat RGBE.
  void writeSky(const std::string& name, int exponent) const {
    std::ofstream out(folder / name, std::ios::binary);
    out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
    const unsigned char pixels[] = {128, 64,  32,  129,
                                    128, 128, 128, static_cast<unsigned char>(129 + exponent)};
    out.write(reinterpret_cast<const char*>(pixels), sizeof pixels);
  }
  static Scene sceneWith(const std::string& file) {
    Scene scene;
    scene.objects = {{.id = Id{1}, .name = "Sky", .content = Light{EnvironmentLight{.file = file}}}};
    scene.nextId = Id{2};
    return scene;
  }
  static const EnvironmentLight& sky(const Scene& scene) {
    return std::get<EnvironmentLight>(std::get<Light>(scene.objects[0].content).kind);
  }
};

TEST_F(AssetsTest, a_sky_is_read_relative_to_its_project_with_three_channels) {
  writeSky("sky.hdr", 3);
  EXPECT_TRUE(isImage(folder / "sky.hdr"));
  Scene scene = sceneWith("sky.hdr");
  EXPECT_TRUE(loadAssets(scene, folder).empty());
  ASSERT_TRUE(sky(scene).image);
  EXPECT_EQ(*sky(scene).image, (Image{2, 1, 3, {1.0f, 0.5f, 0.25f, 8.0f, 8.0f, 8.0f}}));
}

TEST_F(AssetsTest, an_unchanged_file_keeps_its_pixels_identity_and_a_changed_one_does_not) {
  writeSky("sky.hdr", 0);
  Assets assets;
  Scene first = sceneWith("sky.hdr"), again = first, other = first;
  assets.load(first, folder);
  assets.load(again, folder / "." / "");
  EXPECT_EQ(first, again);
  writeSky("sky.hdr", 1);
  fs::last_write_time(folder / "sky.hdr", fs::last_write_time(folder / "sky.hdr") + std::chrono::seconds(2));
  assets.load(other, folder);
  EXPECT_NE(sky(other).image, sky(first).image);
  EXPECT_EQ(sky(other).image->pixels[3], 2.0f);
  EXPECT_EQ(sky(first).image->pixels[3], 1.0f);
}

TEST_F(AssetsTest, a_missing_sky_lets_the_scene_open_with_its_gradient_and_says_so) {
  Scene scene = sceneWith("lost.exr");
  const auto problems = Assets().load(scene, folder);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].missing);
  for (const char* part : {"lost.exr", "No such file", "'Sky'", "choose another"})
    EXPECT_NE(problems[0].message.find(part), std::string::npos) << problems[0].message;
  EXPECT_EQ(sky(scene).image, nullptr);
  EXPECT_EQ(sky(scene).file, "lost.exr");
}

TEST_F(AssetsTest, commands_refuse_a_sky_that_is_missing_damaged_or_no_image) {
  std::ofstream(folder / "text.exr") << "no image";
  std::ofstream(folder / "cut.hdr") << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 900 +X 900\n";
  std::ofstream(folder / "white.png", std::ios::binary) << "\x89PNG\r\n\x1a\n";
  for (const char* name : {"text.exr", "cut.hdr", "white.png", "lost.exr"}) {
    Scene scene = sceneWith(name);
    try {
      loadAssets(scene, folder);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::badInput);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

TEST_F(AssetsTest, a_light_that_names_no_file_loses_the_pixels_it_had) {
  Scene scene = sceneWith("");
  std::get<EnvironmentLight>(std::get<Light>(scene.objects[0].content).kind).image =
      std::make_shared<const Image>(Image{1, 1, 3, {1, 1, 1}});
  EXPECT_TRUE(loadAssets(scene, folder).empty());
  EXPECT_EQ(sky(scene).image, nullptr);
}

TEST_F(AssetsTest, names_stay_true_when_a_project_is_saved_elsewhere) {
  fs::create_directories(folder / "a/maps");
  EXPECT_EQ(assetName(folder / "a/maps/sky.exr", folder / "a"), "maps/sky.exr");
  EXPECT_EQ(assetName(folder / "a/maps/sky.exr", folder / "a/"), "maps/sky.exr");
  EXPECT_EQ(assetName(folder / "sky.exr", folder / "a"), (folder / "sky.exr").string());
  EXPECT_EQ(assetName(folder / "sky.exr", ""), (folder / "sky.exr").string());
  const Scene scene = sceneWith("maps/sky.exr");
  EXPECT_EQ(sky(withAssetsNamedFrom(scene, folder / "a", folder)).file, "a/maps/sky.exr");
  EXPECT_EQ(sky(withAssetsNamedFrom(scene, folder / "a", folder / "b")).file,
            (folder / "a/maps/sky.exr").string());
  EXPECT_EQ(withAssetsNamedFrom(scene, folder / "a", folder / "a"), scene);
}

TEST_F(AssetsTest, the_folder_of_a_project_is_where_its_file_lies) {
  std::ofstream(folder / "room.srad") << "{}";
  EXPECT_EQ(projectFolderOf(folder / "room.srad"), folder);
  EXPECT_EQ(projectFolderOf(folder), folder);
}

}  // namespace
}  // namespace steradian
