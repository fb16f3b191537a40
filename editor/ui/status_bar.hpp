// SPDX-License-Identifier: MIT
// The status bar: what is always visible about the picture and the device.
#pragma once
#include "editor/ui/status_figures.hpp"
#include "editor/ui/ui.hpp"

namespace steradian::ui {

void statusBar(Ui& ui, const StatusInput& input);

}  // namespace steradian::ui
