// SPDX-License-Identifier: MIT
// The interactive editor: a window on one document.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace steradian {

struct EditorOptions {
  std::string file;    // project, project folder or anything an importer reads; empty = a small new scene
  std::string device;  // name part or index; empty = the best one
  std::vector<std::filesystem::path> pluginPath;
  bool validation = false;
};

/// Opens the window and runs until it is closed. Returns the process exit code; 0 after a normal quit.
/// Throws Error(noDevice) when there is no display or no usable Vulkan device.
int runEditor(const EditorOptions& options);

}  // namespace steradian
