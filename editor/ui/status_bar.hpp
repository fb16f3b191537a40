// SPDX-License-Identifier: MIT
// The status bar: what is always visible about the picture and the device.
#pragma once
#include <string>

#include "editor/ui/ui.hpp"
#include "renderer/renderer.hpp"

namespace steradian::ui {

struct StatusInput {
  const DeviceDescription& device;
  const RenderStats& stats;
  bool paused = false;
  bool resting = false;  // the sample limit is reached
};

void statusBar(Ui& ui, const StatusInput& input);

std::string percent(double ratio);           // "1.25 %"
std::string duration(double seconds);        // "1 min 5 s"
std::string countText(std::uint64_t count);  // "12,345"
std::string memoryText(std::size_t bytes);   // "80.1 MiB"

}  // namespace steradian::ui
