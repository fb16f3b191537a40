// SPDX-License-Identifier: MIT
// A part of a still: the sums over some of its samples, to be merged with the others without loss.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "plugins/host/plugin_host.hpp"
#include "renderer/film_sums.hpp"

namespace steradian {

/// All that must agree between parts of one picture, and where this one stands.
struct PartOrigin {
  std::string scene;    // Renderer::sceneFingerprint() in hexadecimal: scene, view, size, settings, seed
  std::string version;  // of the program: another one may sample differently
  std::string project;  // for people
  std::uint32_t seed = 0;
  bool errorMeter = false;           // samples lie in two half-buffers, even and odd
  std::uint64_t begin = 0, end = 0;  // sample indices
  std::uint64_t nan = 0;             // samples that were dropped
  std::set<std::string> devices;
  bool operator==(const PartOrigin&) const = default;
};

/// The exact sums: terms[half][k] are images of 3 channels whose sum over k is the sum of the samples. The
/// first is the float nearest to it, the next the float nearest to what is left, until nothing is: one value,
/// one form.
struct Part {
  PartOrigin origin;
  int width = 0, height = 0;
  std::array<std::vector<Image>, 2> terms;
  std::vector<plugins::ImageLayer> layers;  // beside them: what camera rays alone tell (--aov)
  bool operator==(const Part&) const = default;
};

/// A render's sums as a part. Throws Error(failed) when a row holds more samples than another or a sum went
/// beyond what a film holds.
Part partOf(const FilmSums& sums, PartOrigin origin);

/// Whether a part may lack samples that were not a number and were left out of its sums.
enum class DroppedSamples { refuse, accept };

/// The sum of all parts, the same for any order and any grouping; of each layer the one from the part with
/// the lowest samples. Rendering the same samples at once gives the same part: films, too, add without
/// rounding. Throws Error(badInput), naming the parts by `names`, when they are of other scenes, overlap,
/// leave a gap, hold a sum that is not finite, or lack samples.
Part merged(std::vector<Part> parts, std::vector<std::string> names,
            DroppedSamples dropped = DroppedSamples::refuse);

/// Mean over all samples, rounded once.
Image meanOf(const Part& part);
/// From the half-buffers, as the meter does it on the device; not valid without them.
ErrorEstimate errorOf(const Part& part);

/// As layers sumA.0, sumA.1 ... sumB.0 ..., then its own layers, and metadata of an EXR file.
std::vector<plugins::ImageLayer> layersOf(const Part& part);
std::map<std::string, std::string> partMetadata(const PartOrigin& origin);
/// The reverse. Throws Error(badInput) naming the file when it is not a part.
Part readPart(const std::string& file, const Image& pixels, const std::vector<std::string>& channelNames,
              const std::map<std::string, std::string>& metadata);

}  // namespace steradian
