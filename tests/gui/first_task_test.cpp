// SPDX-License-Identifier: MIT
// A first user's task in the real window: open, add, edit, undo, export, quit; pixels and files are asserted.
#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "tests/gui/editor_task.hpp"

namespace steradian::test {
namespace {

using FirstTask = EditorTask;

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
  quitDiscarding(editor);
}

}  // namespace
}  // namespace steradian::test
