// SPDX-License-Identifier: MIT
// The furnace view in the real window: its curves lie where the material's albedo is, and fall with
// compensation off.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/gui/editor_task.hpp"

namespace steradian::test {
namespace {

using FurnaceTask = EditorTask;

/// Mean height (0 to 1) of a grey material's bright line near the left and the right end.
struct Ends {
  double left = 0.0, right = 0.0;
};
double meanHeight(const Image& plot, int from, int to) {
  double sum = 0.0, count = 0.0;
  for (int y = 0; y < plot.height; ++y)
    for (int x = from; x < to; ++x) {
      const float* p = plot.at(x, y);
      if (std::min({p[0], p[1], p[2]}) < 0.6f) continue;
      sum += 1.0 - (y + 0.5) / plot.height;
      count += 1.0;
    }
  return count > 0.0 ? sum / count : -1.0;
}
Ends endsOf(const Image& plot) {
  const int w = plot.width;
  return {meanHeight(plot, w / 20, w / 5), meanHeight(plot, w - w / 5, w - w / 20)};
}

TEST_F(FurnaceTask, the_furnace_view_shows_what_compensation_gives_back) {
  Driver editor(*screen_, folder_);
  openHello(editor);
  restAfter16Samples(editor);
  editor.click("outliner/Add");
  editor.click("Add/Sphere");
  editor.await("material/Roughness");
  editor.click("material/Metallic", 0.97);
  editor.click("section/Transform");
  editor.click("section/Shape");
  editor.click("material/Furnace view");
  editor.scrollDown("section/Material", 20);
  const Ends compensated = endsOf(editor.picture("material/Furnace"));
  keepScreenshot("furnace_compensated");

  editor.click("inspector/tab/Render");
  editor.click("render/Energy compensation", 0.05);
  editor.click("inspector/tab/Object");
  const Ends single = endsOf(editor.picture("material/Furnace"));
  keepScreenshot("furnace_single");

  EXPECT_GT(compensated.left, 0.5);
  EXPECT_GT(compensated.right, 0.5);
  EXPECT_NEAR(single.left, compensated.left, 0.05);
  EXPECT_LT(single.right, 0.75 * compensated.right);
  quitDiscarding(editor);
}

}  // namespace
}  // namespace steradian::test
