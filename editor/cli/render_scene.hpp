// SPDX-License-Identifier: MIT
// The scene to render: read from the file, at the wanted time, with what the command line overrides.
#pragma once
#include "editor/cli/render.hpp"
#include "plugins/host/plugin_host.hpp"

namespace steradian::cli {

struct PreparedScene {
  Scene scene;
  plugins::Parameters exporterParameters;
};

/// Warns on stderr of what the import could not keep. Throws Error(usage) for an override that is out of
/// range or a parameter that nothing knows, and what PluginHost::importScene and loadAssets throw.
PreparedScene prepareScene(const plugins::PluginHost& host, const RenderOptions& options);

}  // namespace steradian::cli
