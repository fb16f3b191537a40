// SPDX-License-Identifier: MIT
// tinygltf without any way to a file or an image decoder: built into the plugin, because the shared library
// has both, and because libdraco exports another tinygltf under the same names.
#pragma once
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_INCLUDE_JSON
#include <nlohmann/json.hpp>

#include <tiny_gltf.h>  // needs the line above
