// SPDX-License-Identifier: MIT
// Drives the real window by what its widgets are called: the editor writes label -> rectangle, xdotool acts.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "tests/gui/processes.hpp"

namespace steradian::test {

struct Area {
  int x = 0, y = 0, width = 0, height = 0;  // pixels of the window, or of the screen where said
};

class Driver {
 public:
  /// Starts the editor with `arguments` in `folder` on `screen` and waits for its first frame.
  Driver(Screen& screen, const std::filesystem::path& folder, const std::vector<std::string>& arguments = {});

  std::optional<Area> find(const std::string& label) const;
  /// Throws std::runtime_error naming the label when it does not appear in time.
  Area await(const std::string& label, std::chrono::seconds limit = std::chrono::seconds(30)) const;
  bool awaitTitle(const std::string& title, std::chrono::seconds limit = std::chrono::seconds(30)) const;
  std::string title() const;

  /// At a fraction of the widget's width, in its middle height.
  void click(const std::string& label, double across = 0.5);
  void doubleClick(const std::string& label);
  void scrollDown(const std::string& label, int notches);
  void resize(int width, int height);
  void key(const std::string& keys);  // "ctrl+z"
  void type(const std::string& text);

  /// The area on the screen.
  Image picture(const std::string& label) const;
  std::optional<int> awaitExit(std::chrono::seconds limit) { return editor_.wait(limit); }
  std::string output() const;

 private:
  std::string xdotool(const std::string& arguments) const;
  void pointAt(const std::string& label, double across);

  Screen& screen_;
  std::filesystem::path folder_, labels_;
  Process editor_;
  std::string window_;
};

/// Mean absolute difference of the means of 8 x 8 pixel blocks: noise cancels, changes of the picture stay.
double blockDifference(const Image& a, const Image& b);

}  // namespace steradian::test
