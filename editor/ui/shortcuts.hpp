// SPDX-License-Identifier: MIT
// Keys to commands, by what is printed on the keyboard, not by position.
#pragma once
#include "editor/ui/ui.hpp"

namespace steradian::ui {

/// Asks for the commands whose chords were pressed in this frame. Silent while text is typed or a popup is
/// open.
void shortcuts(Ui& ui);

}  // namespace steradian::ui
