// SPDX-License-Identifier: MIT
// Compressed content made plain, before anything looks at it: EXT_meshopt_compression,
// KHR_draco_mesh_compression.
#pragma once
#include "document.hpp"

namespace gltf {

/// Rewrites a checked JSON so that only plain buffer views and accessors remain; what they hold is appended
/// to document.buffers. Accessors without a view, which stand for zeros, get one. What cannot be decoded
/// becomes unsound.
void decompress(Json& json, Document& document);

/// The bytes of one KHR_draco_mesh_compression primitive as plain accessors and views appended to `json`.
/// Throws BadInput with the reason.
void decodeDraco(Json& json, Json& primitive, const std::string& place, Document& document);

/// Appends a view of `bytes`, which become ours, and returns its index.
std::size_t addView(Json& json, Document& document, std::string bytes);

}  // namespace gltf
