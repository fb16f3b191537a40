// SPDX-License-Identifier: MIT
// From the project's display settings and the plugins to the tonemapper that the display pass runs.
#pragma once
#include "plugins/host/plugin_host.hpp"
#include "renderer/renderer.hpp"

namespace steradian {

/// The tonemapper that `display` names, with its parameters within their ranges.
/// Throws Error(badInput) listing the tonemappers there are.
Tonemapper tonemapperFor(const plugins::PluginHost& host, const DisplaySettings& display);

}  // namespace steradian
