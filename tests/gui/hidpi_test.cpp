// SPDX-License-Identifier: MIT
// The real window on a monitor of 192 dpi: all is drawn twice as large as on one of 96, and hit where it is
// drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/gui/editor_task.hpp"

namespace steradian::test {
namespace {

class HiDpiTask : public EditorTask {
 protected:
  HiDpiTask() : EditorTask(1600, 1000) {}
};

/// Columns from the first to the last with something bright: how wide the letters were drawn.
int widthOfLetters(const Image& picture) {
  const auto brightest = [&](int x) {
    float most = 0.0f;
    for (int y = 0; y < picture.height; ++y) most = std::max(most, picture.at(x, y)[1]);
    return most;
  };
  float most = 0.0f;
  for (int x = 0; x < picture.width; ++x) most = std::max(most, brightest(x));
  int first = 0, last = picture.width - 1;
  while (first < last && brightest(first) < 0.5f * most) ++first;
  while (first < last && brightest(last) < 0.5f * most) --last;
  return last - first + 1;
}

/// Lengths in pixels that do not depend on how large the window is.
std::map<std::string, double> lengths(const Driver& editor) {
  std::map<std::string, double> out;
  out["letters of the menu"] = widthOfLetters(editor.picture("menu/View"));  // the pointer is left of it
  out["width of the outliner"] = editor.await("viewport").x;
  out["height of the menu bar"] = editor.await("viewport").y;
  for (const char* label :
       {"menu/View", "outliner/Add", "outliner/Search", "inspector/tab/Render", "status/nan"}) {
    const Area area = editor.await(label);
    out[label + std::string(" across")] = area.width;
    out[label + std::string(" down")] = area.height;
  }
  return out;
}

TEST_F(HiDpiTask, at_192_dpi_all_is_twice_as_large_and_clicks_hit) {
  const fs::path project = folder_ / "hello" / "hello.srad";
  std::map<std::string, double> usual;
  {
    Driver editor(*screen_, folder_, {project});
    editor.await("outliner/Ball");
    usual = lengths(editor);
    keepScreenshot("hidpi_96");
  }
  fs::remove(folder_ / "labels.jsonl");
  screen_->setDpi(192);
  Driver editor(*screen_, folder_, {project});
  editor.await("outliner/Ball");
  // Fonts are whole pixels high, so twice is not exactly 2
  for (const auto& [name, length] : lengths(editor)) EXPECT_NEAR(length / usual.at(name), 2.0, 0.2) << name;
  const Area search = editor.await("outliner/Search"), viewport = editor.await("viewport");
  EXPECT_LT(search.x + search.width, viewport.x) << "the outliner holds its widgets";

  // The ball is in the middle; a selected object shows its material
  editor.click("viewport");
  editor.await("material/Roughness");
  editor.click("menu/Add");
  editor.await("Add/Sphere");
  keepScreenshot("hidpi_192");
  editor.click("Add/Sphere");
  EXPECT_TRUE(editor.awaitTitle("hello.srad* - Steradian")) << editor.title();
  quitDiscarding(editor);
}

}  // namespace
}  // namespace steradian::test
