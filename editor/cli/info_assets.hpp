// SPDX-License-Identifier: MIT
// steradian info: meshes, textures and what an import made of its file.
#pragma once
#include <nlohmann/json.hpp>

#include "plugins/host/plugin_host.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian::cli {

using Json = nlohmann::ordered_json;

Json meshInfo(const Scene& scene);     // once each, and how many objects show it
Json textureInfo(const Scene& scene);  // once each; loaded before
/// What came as something else, what not at all, and remarks; everything else came exactly.
Json importInfo(const plugins::ImportReport& report);

}  // namespace steradian::cli
