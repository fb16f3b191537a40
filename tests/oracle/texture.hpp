// SPDX-License-Identifier: MIT
// Texels as they are written, and lookups between them.
#pragma once
#include "renderer/scene/texture.hpp"

namespace steradian::oracle {

/// RGBA at a place of a mesh's texture coordinates: of the finest level, nearest or bilinear, wrapped as the
/// slot says; `color`: RGB of codes are sRGB (IEC 61966-2-1). White where the slot is empty.
glm::dvec4 lookUp(const TextureSlot& slot, const glm::dvec2& uv, bool color);

}  // namespace steradian::oracle
