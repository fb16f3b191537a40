// SPDX-License-Identifier: MIT
// Files taken into the open document: everything of them, or one message and nothing.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "editor/ui/project_files.hpp"
#include "tests/temporary_folder.hpp"

namespace steradian::ui {
namespace {

namespace fs = std::filesystem;

class ImportTest : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    for (const char* place : {"XDG_CACHE_HOME", "XDG_STATE_HOME"}) setenv(place, folder.c_str(), 1);
    std::ofstream(folder / "chair.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\no leg\nf 1 2 3\no seat\nf 3 2 1\n";
  }
  static Document opened() {
    Scene scene;
    scene.objects = {{.id = Id{1}, .name = "leg", .content = Geometry{Sphere{}}}};
    scene.nextId = Id{2};
    return Document(scene, {});
  }
  static const EnvironmentLight* skyIn(const Scene& scene) {
    const Object* object = find(scene, skyOf(scene));
    return object ? std::get_if<EnvironmentLight>(&std::get<Light>(object->content).kind) : nullptr;
  }

  /// As the frame loop sees a load that came through, and one that did not.
  std::optional<edits::Merged> imported(const Document& document, const fs::path& file) {
    LoadStatus status;
    try {
      return files.import(document, files.read(file, status, projectFolderOf(document.path())));
    } catch (const Error& error) {
      files.failed(file, error.what());
      return std::nullopt;
    }
  }

  static const plugins::PluginHost& host() {
    static const plugins::PluginHost stock({STOCK_PLUGINS});
    return stock;
  }
  Messages messages;
  ProjectFiles files{host(), messages};
};

TEST_F(ImportTest, a_model_comes_under_one_group_named_after_its_file) {
  const Document document = opened();
  const auto merged = imported(document, folder / "chair.obj");
  ASSERT_TRUE(merged);
  EXPECT_EQ(find(merged->scene, merged->group)->name, "chair");
  EXPECT_EQ(merged->objects.size(), 2u);
  EXPECT_EQ(merged->scene.objects.size(), 4u) << "no camera and no sky beside what is there";
  EXPECT_TRUE(findByName(merged->scene, "leg.001"));
  EXPECT_EQ(messages.errors(), 0);
}

TEST_F(ImportTest, a_file_that_cannot_be_read_is_one_message_and_no_change) {
  std::ofstream(folder / "bad.obj") << "v 0 0 0\nf 1 2 3\n";
  for (const char* name : {"bad.obj", "lost.obj", "lost.xyz"}) {
    const int before = messages.errors();
    EXPECT_FALSE(imported(opened(), folder / name)) << name;
    EXPECT_EQ(messages.errors(), before + 1) << name;
  }
}

TEST_F(ImportTest, a_model_that_is_opened_is_seen_and_is_a_new_project) {
  LoadStatus status;
  const Document document = files.open(files.read(folder / "chair.obj", status));
  EXPECT_TRUE(document.unsaved());
  EXPECT_TRUE(document.path().empty());
  EXPECT_TRUE(skyIn(document.scene()));
  EXPECT_EQ(document.scene().objects.size(), 4u);
}

TEST_F(ImportTest, a_cancelled_import_reads_no_further) {
  LoadStatus status;
  status.cancel();
  EXPECT_THROW(files.read(folder / "chair.obj", status), Error);
  EXPECT_EQ(messages.errors(), 0);
}

TEST_F(ImportTest, a_scene_that_is_only_read_changes_no_list_and_tells_nothing) {
  LoadStatus status;
  const ReadScene read = files.read(folder / "chair.obj", status);
  EXPECT_EQ(read.path, folder / "chair.obj");
  EXPECT_TRUE(files.recent().paths().empty());
  EXPECT_EQ(status.shown().step, "Decoding images");
  files.open(read);
  EXPECT_EQ(files.recent().paths().size(), 1u);
}

TEST_F(ImportTest, an_imported_scene_keeps_its_files_by_name_from_where_it_is) {
  fs::create_directories(folder / "lib");
  std::ofstream(folder / "lib/lamp.srad")
      << R"({"steradian": 2, "textures": [{"id": 1, "file": "t.png"}], "materials": [{"id": 1, "albedoTexture": {"texture": 1}}]})";
  const Document document(Scene{}, folder / "room.srad");
  const auto merged = imported(document, folder / "lib/lamp.srad");
  ASSERT_TRUE(merged);
  EXPECT_EQ(merged->scene.materials.at(0).albedoTexture.texture->file, "lib/t.png");
}

TEST_F(ImportTest, a_sky_becomes_the_environment_light_or_a_new_one) {
  std::ofstream(folder / "sky.hdr", std::ios::binary) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n"
                                                      << std::string("\x80\x80\x80\x81", 4);
  EXPECT_TRUE(files.isSky(folder / "sky.hdr"));
  const Document document = opened();
  const ReadSky read = files.readSky(folder / "sky.hdr");
  const auto first = files.withSky(document, skyOf(document.committed()), read);
  ASSERT_TRUE(first);
  ASSERT_TRUE(skyIn(*first) && skyIn(*first)->image);
  EXPECT_EQ(first->objects.size(), 2u);
  const Document again(*first, {});
  const auto second = files.withSky(again, skyOf(*first), read);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->objects.size(), 2u) << "the one that is there";
  std::ofstream(folder / "bad.hdr") << "#?RADIANCE\n";
  EXPECT_THROW(files.readSky(folder / "bad.hdr"), Error);
  EXPECT_FALSE(files.withSky(document, Id{1}, read)) << "no environment light";
}

}  // namespace
}  // namespace steradian::ui
