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
