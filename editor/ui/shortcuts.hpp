// SPDX-License-Identifier: MIT
// Keys to commands, by what is printed on the keyboard, not by position.
#pragma once
#include <vector>

#include "editor/ui/ui.hpp"
#include "editor/window.hpp"

namespace steradian::ui {

/// Asks for the commands whose chords are among `presses`. Silent while text is typed or a popup is open.
void shortcuts(Ui& ui, const std::vector<KeyPress>& presses);

}  // namespace steradian::ui
