// SPDX-License-Identifier: MIT
// The status bar in the real window, and the keyboard while a menu is open.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/gui/editor_task.hpp"

namespace steradian::test {
namespace {

/// A floor that is lit by way of a shiny ball alone. Its sharp highlight is met once in 1e7 paths: until then
/// the fireflies grow brighter.
constexpr const char* kFireflies = R"({"steradian": 1, "name": "Fireflies",
  "render": {"width": 128, "height": 128, "maxBounces": 2},
  "materials": [
    {"id": 1, "name": "Floor", "albedo": [0.8, 0.8, 0.8], "roughness": 1},
    {"id": 2, "name": "Chrome", "albedo": [0.9, 0.9, 0.9], "metallic": 1, "roughness": 0.05}],
  "objects": [
    {"id": 3, "name": "Camera", "translation": [3, 2, 2.5], "rotation": [-0.3826834, 0, 0, 0.9238795],
     "camera": {"fovY": 0.6}},
    {"id": 4, "name": "Floor", "plane": {}, "material": 1},
    {"id": 5, "name": "Ball", "translation": [-1, 1, 0.5], "sphere": {"radius": 1}, "material": 2},
    {"id": 6, "name": "Spot", "translation": [2, 1, 0.5], "rotation": [0, 0.7071068, 0, 0.7071068],
     "spotLight": {"intensity": 1000, "outerConeAngle": 0.2}}]})";

class StatusTask : public EditorTask {
 protected:
  StatusTask() : EditorTask(1280, 720) {}

  static bool awaitGone(const Driver& editor, const std::string& label) {
    for (int i = 0; i < 100 && editor.find(label); ++i) std::this_thread::sleep_for(100ms);
    return !editor.find(label).has_value();
  }
  /// Every figure that is shown lies within the window.
  static void expectFits(const Driver& editor, int width) {
    for (const char* name : {"samples", "time", "rays", "error", "outlook", "fireflies", "clamp", "nan",
                             "cpu", "variant", "device"})
      if (const auto area = editor.find(std::string("status/") + name))
        EXPECT_LE(area->x + area->width, width) << name;
  }
};

TEST_F(StatusTask, the_status_bar_warns_of_fireflies_and_of_what_the_clamp_takes) {
  const fs::path project = folder_ / "fireflies.srad";
  std::ofstream(project) << kFireflies;
  Driver editor(*screen_, folder_, {project.string()});
  ASSERT_TRUE(editor.awaitTitle("fireflies.srad - Steradian")) << editor.title();
  editor.await("status/outlook", 120s);
  restAfter16Samples(editor);
  editor.await("status/fireflies", 120s);
  editor.await("status/done", 120s);
  EXPECT_FALSE(editor.find("status/clamp"));
  expectFits(editor, 1280);
  keepScreenshot("status_fireflies");

  editor.click("inspector/tab/Render");
  editor.click("render/Clamp", 0.05);
  editor.await("status/clamp");
  editor.await("status/done", 120s);
  expectFits(editor, 1280);
  keepScreenshot("status_clamp");
  editor.resize(800, 600);
  std::this_thread::sleep_for(2s);
  editor.await("status/error");
  editor.await("status/nan");
  expectFits(editor, 800);
  keepScreenshot("status_narrow");
  quitDiscarding(editor);
}

TEST_F(StatusTask, escape_closes_a_menu_and_shortcuts_work_while_one_is_open) {
  Driver editor(*screen_, folder_);
  editor.click("menu/View");
  editor.await("View/Rest after");
  editor.click("View/Rest after");
  editor.await("Rest after/16 samples");
  editor.key("Escape");
  EXPECT_TRUE(awaitGone(editor, "Rest after/16 samples"));
  EXPECT_TRUE(awaitGone(editor, "View/Rest after"));

  editor.click("menu/File");
  editor.await("File/Save");
  editor.key("p");
  editor.await("status/paused");
  EXPECT_TRUE(awaitGone(editor, "File/Save"));
  editor.key("ctrl+q");
  const std::optional<int> code = editor.awaitExit(20s);
  ASSERT_TRUE(code.has_value()) << "the editor did not end";
  EXPECT_EQ(*code, 0) << editor.output();
}

}  // namespace
}  // namespace steradian::test
