// SPDX-License-Identifier: MIT
// How different two images are, the second being the reference.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "renderer/scene/image.hpp"

namespace steradian::cli {

/// Over the first three channels (a grey image counts as three equal ones), in double. Values that are not
/// finite in either image are counted and left out of every figure.
struct ImageDifference {
  std::array<double, 3> meanRatio{};  // mean(a) / mean(b) per channel; 1 when both are 0
  double mse = 0.0;                   // mean (a - b)^2
  double rmse = 0.0;                  // its square root
  double relMse = 0.0;                // mean (a - b)^2 / (b^2 + 0.01)
  double relRmse = 0.0;               // its square root
  double smape = 0.0;                 // mean 2 |a - b| / (|a| + |b|), 0 where both are 0; in [0, 2]
  double smapeDisplay = 0.0;          // smape of both as an sRGB screen shows them: clipped, encoded
  double max = 0.0;                   // largest |a - b|
  std::uint64_t nan = 0, inf = 0;     // values, in both images together
};

/// A PNG is display-encoded already, an EXR is scene-linear: what a value means for smapeDisplay.
enum class Encoding { sceneLinear, display };
struct Encodings {
  Encoding image = Encoding::sceneLinear, reference = Encoding::sceneLinear;
};

/// Throws Error(badInput) when the sizes differ.
ImageDifference differenceOf(const Image& image, const Image& reference, Encodings encodings = {});

/// The figures by their names in --json, in order; meanRatio, nan and inf apart.
std::vector<std::pair<std::string, double>> figuresOf(const ImageDifference& difference);

/// "relRmse=0.01": an upper bound for a figure. Throws Error(usage) listing the figures.
struct FigureLimit {
  std::string figure;
  double atMost = 0.0;
};
FigureLimit parseLimit(const std::string& text);
/// One line for each limit that is exceeded. Values that are not finite are left out of every figure, so they
/// fail any limit.
std::vector<std::string> exceeded(const ImageDifference& difference, const std::vector<FigureLimit>& limits);

}  // namespace steradian::cli
