// SPDX-License-Identifier: MIT
// The progress window of a file that is being read.
#pragma once
#include "editor/ui/loading.hpp"
#include "editor/ui/ui.hpp"

namespace steradian::ui {

/// True when the person cancels. In the middle when the document waits for the file, else in the viewport's
/// corner; nothing for what is read in a blink.
bool drawLoading(Ui& ui, const Loading& loading, ImVec2 bottomRight);

}  // namespace steradian::ui
