// SPDX-License-Identifier: MIT
// A first user's task in the real window: open, add, edit, undo, export, quit; pixels and files are asserted.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "plugins/host/plugin_host.hpp"
#include "tests/gui/driver.hpp"

namespace steradian::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class FirstTask : public testing::Test {
 protected:
  FirstTask() {
    char name[] = "/tmp/steradian-gui-XXXXXX";
    folder_ = mkdtemp(name);
    fs::copy(fs::path(STERADIAN_TEST_PROJECTS) / "hello", folder_ / "hello", fs::copy_options::recursive);
    screen_.emplace(folder_, 1040, 720);
  }
  ~FirstTask() override {
    screen_.reset();
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  /// The picture after it came to rest, so that two of them hold the same samples.
  Image restingPicture(Driver& editor) {
    std::this_thread::sleep_for(1500ms);  // the edit is taken and sampling has started over
    editor.await("status/done", 120s);
    return editor.picture("viewport");
  }

  void keepScreenshot(const std::string& name) {
    const fs::path folder = STERADIAN_TEST_ARTEFACTS;
    fs::create_directories(folder);
    const Image shot = screen_->read();
    const plugins::PluginHost host({STERADIAN_TEST_PLUGINS});
    host.exportImage({shot.width, shot.height, shot.pixels.data(), shot.pixels.data(), {}},
                     folder / (name + ".png"));
  }

  void openHello(Driver& editor) {
    editor.key("ctrl+o");
    editor.await("browser/name");
    editor.type((folder_ / "hello" / "hello.srad").string());
    editor.click("browser/accept");
    ASSERT_TRUE(editor.awaitTitle("hello.srad - Steradian")) << editor.title();
  }

  void restAfter16Samples(Driver& editor) {
    editor.click("menu/View");
    editor.click("View/Rest after");
    editor.click("Rest after/16 samples");
  }

  fs::path folder_;
  std::optional<Screen> screen_;
};

TEST_F(FirstTask, open_add_a_sphere_roughen_it_undo_export_and_quit) {
  Driver editor(*screen_, folder_);
  openHello(editor);
  restAfter16Samples(editor);

  // Add a sphere: it is selected, and the title says that something is unsaved
  editor.click("outliner/Add");
  editor.click("Add/Sphere");
  ASSERT_TRUE(editor.awaitTitle("hello.srad* - Steradian")) << editor.title();
  editor.await("material/Roughness");
  const Image before = restingPicture(editor);

  // Make it a mirror-like one: the viewport changes
  editor.click("material/Roughness", 0.06);
  const Image smooth = restingPicture(editor);
  keepScreenshot("first_task");
  EXPECT_GT(blockDifference(before, smooth), 0.001);

  // Undo brings the old picture back
  editor.key("ctrl+z");
  const Image after = restingPicture(editor);
  EXPECT_LT(blockDifference(before, after), 0.25 * blockDifference(before, smooth));

  // Export a PNG
  const fs::path png = folder_ / "out.png";
  editor.key("ctrl+e");
  editor.doubleClick("export/Samples");
  editor.key("ctrl+a");
  editor.type("4");
  editor.key("Return");
  editor.click("export/File", 0.3);
  editor.key("ctrl+a");
  editor.type(png.string());
  editor.click("export/Render");
  for (int i = 0; i < 600 && !fs::exists(png); ++i) std::this_thread::sleep_for(100ms);
  char signature[8] = {};
  std::ifstream(png, std::ios::binary).read(signature, 8);
  EXPECT_EQ(std::string(signature + 1, 3), "PNG") << editor.output();

  // Quit: the sphere is unsaved, so the editor asks first
  editor.key("ctrl+q");
  editor.click("dialog/Discard");
  const std::optional<int> code = editor.awaitExit(20s);
  ASSERT_TRUE(code.has_value()) << "the editor did not end";
  EXPECT_EQ(*code, 0) << editor.output();
  EXPECT_NE(editor.output().find("steradian: 0 validation messages"), std::string::npos) << editor.output();
}

}  // namespace
}  // namespace steradian::test
