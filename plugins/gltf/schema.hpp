// SPDX-License-Identifier: MIT
// The rules of glTF 2.0 for single values: type, range, and that every index counts into its list.
#pragma once
#include "document.hpp"

namespace gltf {

/// Throws BadInput "accessors[3].byteOffset: expected a whole number from 0 to ..., got -4" where the file as
/// a whole is unsound (buffers, nodes, scenes, the lists themselves). Where one accessor, primitive, material
/// ... is, the answer holds the same line under its place, and a harmless element takes its place in `json`.
/// Whole numbers that were written as 3.0 become 3.
Unsound checkValues(Json& json);

}  // namespace gltf
