// SPDX-License-Identifier: MIT
// Lights with a size and skies in the real window: add them, change their kind, give a sky its image.
#include <gtest/gtest.h>

#include "tests/gui/editor_task.hpp"

namespace steradian::test {
namespace {

using LightsTask = EditorTask;

TEST_F(LightsTask, add_a_panel_make_it_a_sky_and_choose_its_image) {
  fs::copy(fs::path(STERADIAN_TEST_PROJECTS) / "sky" / "sky.exr", folder_ / "hello" / "sky.exr");
  Driver editor(*screen_, folder_);
  openHello(editor);
  restAfter16Samples(editor);
  const Image before = restingPicture(editor);

  // A lamp with a size lights the scene
  editor.click("outliner/Add");
  editor.click("Add/Rectangle light");
  editor.await("light/Size X");
  const Image lit = restingPicture(editor);
  EXPECT_GT(blockDifference(before, lit), 0.001);
  keepScreenshot("rectangle_light");

  // The same light as a sky, then with an image
  editor.click("light/Kind");
  editor.click("light/Kind/Environment");
  editor.await("light/Horizon");
  const Image sky = restingPicture(editor);
  EXPECT_GT(blockDifference(lit, sky), 0.001);
  editor.click("light/Choose image");
  chooseFile(editor, folder_ / "hello" / "sky.exr");
  editor.await("light/Pixels");
  const Image image = restingPicture(editor);
  EXPECT_GT(blockDifference(sky, image), 0.001);
  keepScreenshot("sky_image");

  // One step back is the plain sky again
  editor.key("ctrl+z");
  EXPECT_LT(blockDifference(sky, restingPicture(editor)), 0.25 * blockDifference(sky, image));

  quitDiscarding(editor);
}

}  // namespace
}  // namespace steradian::test
