// SPDX-License-Identifier: MIT
// How the editor looks: one calm dark theme, one font, sizes for the monitor's scale.
#pragma once
#include <imgui.h>

#include "editor/window.hpp"

namespace steradian::ui {

/// Colours that panels draw with; ImGui's own are set from the same values.
namespace color {
constexpr ImU32 kAccent = IM_COL32(232, 160, 76, 255);  // selection, the one warm colour
constexpr ImU32 kText = IM_COL32(219, 221, 224, 255);
constexpr ImU32 kDim = IM_COL32(136, 141, 149, 255);
constexpr ImU32 kGood = IM_COL32(126, 190, 132, 255);
constexpr ImU32 kWarning = IM_COL32(226, 184, 92, 255);
constexpr ImU32 kError = IM_COL32(232, 108, 100, 255);
constexpr ImU32 kLine = IM_COL32(15, 16, 18, 255);
}  // namespace color

/// Theme and spacing of the current ImGui context.
void applyStyle(UiScale scale);

/// The nicest installed sans-serif font, else ImGui's built-in one. Replaces all fonts.
void loadFonts(UiScale scale);

}  // namespace steradian::ui
