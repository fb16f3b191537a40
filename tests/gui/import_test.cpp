// SPDX-License-Identifier: MIT
// A model taken into the open scene in the real window: it is seen, it is one step, and undo takes it back.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/gui/editor_task.hpp"

namespace steradian::test {
namespace {

using ImportTask = EditorTask;

TEST_F(ImportTask, import_a_model_save_it_and_take_it_back) {
  std::ofstream(folder_ / "roof.obj") << "v -2 0 -2\nv 2 0 -2\nv 2 0 2\nv -2 0 2\nv 0 3 0\n"
                                         "f 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 5\n";
  Driver editor(*screen_, folder_);
  openHello(editor);
  restAfter16Samples(editor);

  // One that never ends: the window goes on, and cancelling gives everything back
  std::ofstream(folder_ / "endless.wait") << "x";
  editor.click("menu/File");
  editor.click("File/Import...");
  chooseFile(editor, folder_ / "endless.wait");
  editor.await("loading/Progress");
  const int statusBefore = editor.await("status/samples").y;
  editor.resize(1000, 640);
  for (int i = 0; i < 100 && editor.await("status/samples").y == statusBefore; ++i)
    std::this_thread::sleep_for(50ms);
  EXPECT_NE(editor.await("status/samples").y, statusBefore) << "frames are drawn while a file is read";
  keepScreenshot("loading");
  editor.click("loading/Cancel");
  EXPECT_EQ(editor.title(), "hello.srad - Steradian");
  const Image before = restingPicture(editor);

  editor.click("menu/File");
  editor.click("File/Import...");
  chooseFile(editor, folder_ / "roof.obj");
  ASSERT_TRUE(editor.awaitTitle("hello.srad* - Steradian")) << editor.title();
  const Image imported = restingPicture(editor);
  keepScreenshot("import");
  EXPECT_GT(blockDifference(before, imported), 0.01);

  editor.key("ctrl+s");
  ASSERT_TRUE(editor.awaitTitle("hello.srad - Steradian")) << editor.title();
  EXPECT_TRUE(fs::is_directory(folder_ / "hello" / "hello.assets"));
  editor.key("ctrl+z");
  ASSERT_TRUE(editor.awaitTitle("hello.srad* - Steradian")) << "one step: " << editor.title();
  quitDiscarding(editor);
}

}  // namespace
}  // namespace steradian::test
