// SPDX-License-Identifier: MIT
// Squared errors over squared light, where neither is known but by the halves of a film.
#pragma once
#include <span>

#include "renderer/renderer.hpp"

namespace steradian {

/// Added to the light's square, so that black pixels count little: (a tenth of white)^2.
inline constexpr double kRelativeFloor = 0.01;

/// Mean over pixels and channels of variance / (light^2 + kRelativeFloor). `means` and the `variances` of
/// these means: width * height * 3, rows from the top. As shaders/relative_error.glsl, which says why, in
/// double.
double meanRelativeSquare(Extent extent, std::span<const double> means, std::span<const double> variances);

}  // namespace steradian
