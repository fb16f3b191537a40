// SPDX-License-Identifier: MIT
// The --aov option of steradian render: names to layers of the image file.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "plugins/host/plugin_host.hpp"
#include "renderer/renderer.hpp"

namespace steradian::cli {

/// "albedo,normal" or "all", in the order given, each once. Throws Error(usage): a name is unknown, none of
/// the outputs is an EXR file, or the variance is asked for without the meter, or a figure of the whole film
/// of a part of it.
std::vector<Aov> parseAovs(const std::string& text, const std::vector<std::filesystem::path>& outputs,
                           bool errorMeter, bool part);

/// What the layers of the file hold, from the renderer's film and first hits; in all parts of a picture the
/// same.
std::vector<plugins::ImageLayer> aovLayers(Renderer& renderer, const std::vector<Aov>& kinds, bool part);

}  // namespace steradian::cli
