// SPDX-License-Identifier: MIT
// Arbitrary output variables: what the pixels of a picture show beside their radiance.
#pragma once
#include <string>
#include <vector>

#include "renderer/scene/image.hpp"

namespace steradian {

enum class Aov { albedo, normal, depth, id, coverage, samples, variance };

/// All of them, in the order of the enumeration.
inline constexpr Aov kAllAovs[] = {Aov::albedo,   Aov::normal,  Aov::depth,   Aov::id,
                                   Aov::coverage, Aov::samples, Aov::variance};
/// "albedo", "normal" ...: also the name of its layer.
const char* nameOf(Aov aov);

/// The values of one variable in the picture's pixels. Channels:
/// albedo    R G B   of the first surface, mean over the samples, 0 where they miss
/// normal    X Y Z   world, unit, towards the viewer; mean over the samples, 0 where they miss
/// depth     Z       metres along the ray, mean over the samples that hit; infinite where none does
/// id        ID      of the object under the pixel's centre as a whole number, 0 = none
/// coverage  A       share of the samples that hit something
/// samples   N       radiance samples of the pixel
/// variance  R G B   of the mean radiance, (nit)^2, estimated from the two half-buffers: right on average
/// over
///                   many pixels, one pixel's own value has a relative deviation of sqrt(2); infinite while a
///                   half holds nothing
struct AovLayer {
  std::string name;
  std::vector<std::string> channels;
  Image pixels;
};

struct AovRequest {
  std::vector<Aov> kinds;
  int samples = 64;  // camera rays per pixel, the picture's own first ones; 1..4096
};

}  // namespace steradian
