// SPDX-License-Identifier: MIT
// What a mesh carries to the place that a ray meets: smooth normals, and textures for its material.
#pragma once
#include "tests/oracle/intersect.hpp"

namespace steradian::oracle {

/// The normal that reflection turns around: a mesh's own, interpolated over the triangle (Phong 1975) and
/// bent by its normal texture (glTF 2.0, section 3.9.3); else the surface's. Unit, world.
dvec3 shadingNormal(const Hit& hit);

/// The body's finish with the textures and vertex colours of this place; nothing where it is the same all
/// over. Albedo tables stay those of the untextured roughness.
std::optional<Finish> paintedFinish(const Hit& hit);

/// Nit, on either side.
dvec3 emissionAt(const Hit& hit);

/// The share of the light that meets the surface at all; the rest passes straight on.
double opacityAt(const Hit& hit);

}  // namespace steradian::oracle
