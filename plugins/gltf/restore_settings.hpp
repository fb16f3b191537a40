// SPDX-License-Identifier: MIT
// The settings that Steradian's own exporter wrote for the whole scene, under extras.steradian.
#pragma once
#include <deque>
#include <vector>

#include "document.hpp"

namespace gltf {

/// Reads over `start`. Throws BadInput.
sdk::RenderSettingsRecord restoreRender(const Json& render, const sdk::RenderSettingsRecord& start);

/// A display with the texts that its record points to.
struct OwnDisplay {
  std::deque<std::string> texts;
  std::vector<sdk::ParameterValue> parameters;
  sdk::DisplaySettingsRecord record;
};

/// Throws BadInput. The record is sound for as long as `out` lives and stays where it is.
void restoreDisplay(const Json& display, OwnDisplay& out);

}  // namespace gltf
