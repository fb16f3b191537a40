// SPDX-License-Identifier: MIT
// Animations: tracks for the scene, and the pose at one time for what is baked.
#pragma once
#include "transforms.hpp"

namespace gltf {

enum class Path { translation, rotation, scale, weights };
enum class Interpolation { step, linear, cubic };

/// One property of one node over time.
struct Track {
  std::size_t node = 0;
  Path path = Path::translation;
  Interpolation interpolation = Interpolation::linear;
  int components = 3;         // of a value
  std::vector<float> times;   // seconds, strictly increasing
  std::vector<float> values;  // per key `components`; cubic: in-tangent, value, out-tangent

  /// Held before the first key and after the last. `components` numbers; rotations are unit.
  std::vector<double> at(double time) const;
};

/// The tracks of one animation, or of all (-1): of two that move the same, the first counts. What is unsound
/// or not kept goes to the report.
std::vector<Track> readTracks(const Document& document, int animation, Report& report);

/// Pushes the tracks that move objects; `objectOf` gives a node's object, 0 = none.
void addChannels(const std::vector<Track>& tracks, const std::vector<std::uint32_t>& objectOf,
                 const Document& document, Report& report, sdk::SceneSink& sink);

/// All nodes of a file at one time.
struct Pose {
  std::vector<glm::dmat4> world;
  std::vector<std::vector<double>> weights;  // empty: the node has none of its own
};
Pose poseAt(const Document& document, const std::vector<Track>& tracks, double time);

}  // namespace gltf
