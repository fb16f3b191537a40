// SPDX-License-Identifier: MIT
// What the status bar says, as text: which figures, what they mean, and which give way in a narrow window.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include <imgui.h>

#include "renderer/renderer.hpp"

namespace steradian::ui {

/// How far the picture in the viewport is from being good enough.
struct Goal {
  double target = 0.01;           // relative RMSE
  std::uint64_t measuredAt = 0;   // samples that stats.error belongs to
  double secondsPerSample = 0.0;  // wall time; 0 = not known yet
  std::uint64_t sampleLimit = 0;  // where the viewport rests; 0 = nowhere
};

struct StatusInput {
  const DeviceDescription& device;
  const RenderStats& stats;
  Goal goal;
  bool paused = false;
  bool resting = false;  // the sample limit is reached
};

struct StatusFigure {
  std::string label;               // for tests
  std::vector<std::string> forms;  // from the fullest to the shortest; "" = may be left out
  std::string help;
  ImU32 tint;
  int rank = 0;  // figures of the highest rank are shortened first
};

std::vector<StatusFigure> statusFigures(const StatusInput& input);

/// The form of each figure that is shown, so that all of them and the gaps between them are no wider than
/// `available`, or as narrow as can be.
std::vector<std::string> fittedForms(const std::vector<StatusFigure>& figures, float available, float gap,
                                     const std::function<float(const std::string&)>& widthOf);

}  // namespace steradian::ui
