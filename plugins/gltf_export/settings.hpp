// SPDX-License-Identifier: MIT
// What belongs to the picture and not to the scene: glTF has no word for it.
#pragma once
#include <steradian/plugin.hpp>

#include "document.hpp"

namespace gltf_export {

/// Settings of rendering, display and time, for extras.steradian of the scene.
Json settingsOf(steradian::sdk::SceneView& view);

}  // namespace gltf_export
