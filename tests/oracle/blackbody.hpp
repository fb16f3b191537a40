// SPDX-License-Identifier: MIT
// The colour of a hot body: Planck's law seen by the CIE's observer of 1931.
#pragma once
#include <glm/glm.hpp>

namespace steradian::oracle {

/// XYZ of a black body, Y = 1.
glm::dvec3 planckXyz(double kelvin);

/// XYZ to linear Rec. 709, derived from its primaries and its white (D65).
glm::dvec3 rec709FromXyz(const glm::dvec3& xyz);

/// Linear Rec. 709 of a black body, luminance 1; below 1,900 K its blue is negative.
glm::dvec3 blackbodyColor(double kelvin);

}  // namespace steradian::oracle
