// SPDX-License-Identifier: MIT
// Small line icons drawn with ImGui's lines, so that no icon font is needed.
#pragma once
#include <imgui.h>

#include "editor/edits.hpp"

namespace steradian::ui {

/// The kind of an object: its shape, light, camera or group, in a square of `size` around `center`.
void drawKindIcon(ImDrawList& list, ImVec2 center, float size, const edits::Content& content, ImU32 color);
void drawEye(ImDrawList& list, ImVec2 center, float size, bool open, ImU32 color);

}  // namespace steradian::ui
