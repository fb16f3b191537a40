// SPDX-License-Identifier: MIT
// The lists "meshes" and "textures", and the files beside the project that they name.
#pragma once
#include "keys.hpp"
#include "texts.hpp"

namespace project {

/// Reads both lists and hands meshes and textures to the sink. A mesh that cannot be read is a BadInput with
/// its place; a texture becomes one that names the file, so that the scene can be shown and saved without it.
void readAssets(steradian::sdk::Host& host, Fields& root, Texts& texts, steradian::sdk::SceneSink& sink);

OrderedJson meshesJson(steradian::sdk::Host& host, steradian::sdk::SceneView& view,
                       steradian::sdk::Writer& writer);
OrderedJson texturesJson(steradian::sdk::Host& host, steradian::sdk::SceneView& view,
                         steradian::sdk::Writer& writer);

}  // namespace project
