// SPDX-License-Identifier: MIT
// One camera ray, and the light that one random path brings back along it.
#pragma once
#include "tests/oracle/intersect.hpp"
#include "tests/oracle/random.hpp"

namespace steradian::oracle {

/// A ray through pixel (x, y) of a film, unit direction: pinhole, thin lens or parallel, box or
/// Blackman-Harris.
Ray cameraRay(const Scene& scene, const CameraView& view, const dvec2& pixel, const dvec2& film,
              Random& random);

/// Radiance in nit that arrives against the ray.
dvec3 radiance(const World& world, Ray ray, int maxBounces, Random& random);

}  // namespace steradian::oracle
