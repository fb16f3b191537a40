// SPDX-License-Identifier: MIT
// A test that drives the real window: a screen, a folder with a copy of the hello project, and common steps.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <thread>

#include "plugins/host/plugin_host.hpp"
#include "tests/gui/driver.hpp"

namespace steradian::test {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class EditorTask : public testing::Test {
 protected:
  explicit EditorTask(int width = 1040, int height = 720) {
    char name[] = "/tmp/steradian-gui-XXXXXX";
    folder_ = mkdtemp(name);
    fs::copy(fs::path(STERADIAN_TEST_PROJECTS) / "hello", folder_ / "hello", fs::copy_options::recursive);
    screen_.emplace(folder_, width, height);
  }
  ~EditorTask() override {
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

  /// In the file browser that has just been asked for.
  void chooseFile(Driver& editor, const fs::path& file) {
    editor.click(
        "browser/name");  // on a busy machine the field has the keyboard some frames later than it shows
    editor.key("ctrl+a");
    editor.type(file.string());
    editor.click("browser/accept");
  }

  void openHello(Driver& editor) {
    editor.key("ctrl+o");
    chooseFile(editor, folder_ / "hello" / "hello.srad");
    ASSERT_TRUE(editor.awaitTitle("hello.srad - Steradian")) << editor.title();
  }

  void restAfter16Samples(Driver& editor) {
    editor.click("menu/View");
    editor.click("View/Rest after");
    editor.click("Rest after/16 samples");
  }

  /// Leaves unsaved changes behind; the editor must end in peace.
  void quitDiscarding(Driver& editor) {
    editor.key("ctrl+q");
    editor.click("dialog/Discard");
    const std::optional<int> code = editor.awaitExit(20s);
    ASSERT_TRUE(code.has_value()) << "the editor did not end";
    EXPECT_EQ(*code, 0) << editor.output();
    EXPECT_NE(editor.output().find("steradian: 0 validation messages"), std::string::npos) << editor.output();
  }

  fs::path folder_;
  std::optional<Screen> screen_;
};

}  // namespace steradian::test
