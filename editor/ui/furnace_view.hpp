// SPDX-License-Identifier: MIT
// The furnace view of the material inspector.
#pragma once
#include "editor/ui/widgets.hpp"
#include "renderer/scene/material.hpp"

namespace steradian::ui {

/// A small plot of albedo against roughness, one line per channel or a grey one for all, with an upright line
/// at the material's own roughness. `compensated` as the scene renders.
void furnaceView(Ui& ui, const Material& material, bool compensated);

}  // namespace steradian::ui
