// SPDX-License-Identifier: MIT
// From the bytes of a file to a Document: container, JSON, rules, buffers, typed model.
#pragma once
#include "document.hpp"

namespace gltf {

/// The keys of extensions that this importer understands.
bool knowsExtension(std::string_view name);

/// Throws BadInput with file place and what was expected.
Document openDocument(sdk::Host& host, std::string_view file);

}  // namespace gltf
