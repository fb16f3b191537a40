// SPDX-License-Identifier: MIT
// The independent reference: a brute-force path tracer in double, written from the papers. It shares no file
// and no algorithm with the renderer, so an error in common is unlikely; it is slow, and meant for tiny
// pictures.
#pragma once
#include <cstdint>
#include <vector>

#include "renderer/scene/scene.hpp"

namespace steradian::oracle {

/// Per pixel, row-major from the top left: mean and variance of one sample's radiance (nit, linear Rec. 709).
struct Estimate {
  int width = 0, height = 0;
  double samples = 0.0;  // per pixel
  std::vector<glm::dvec3> mean, variance;
};

/// Next directions are drawn evenly from the hemisphere (through rough glass: from the sphere), mirrors are
/// followed, and nothing else: no next-event estimation but for lights that no ray can hit, no importance
/// sampling, no roulette, no acceleration structure. Emission of surfaces counts at the camera ray's hit and
/// at the next `maxBounces`; lights (Light objects, the sky) count one step further, where a point light's
/// illumination of the last surface does. Solids with transmission stand in air and are not nested; the
/// camera stands outside of them. Takes all cores; the same seed gives the same numbers on any number of
/// them.
Estimate trace(const Scene& scene, const CameraView& view, int width, int height, int samples,
               std::uint64_t seed = 1);

}  // namespace steradian::oracle
