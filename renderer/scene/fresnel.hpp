// SPDX-License-Identifier: MIT
// Reflectance of metals: Fresnel's equations with a complex index, and the curve that materials keep of them.
#pragma once
#include <glm/glm.hpp>

namespace steradian {

/// Unpolarized reflectance of a conductor of index n + ik in air, by the cosine to its normal (Born & Wolf,
/// "Principles of Optics", 14.2).
double conductorReflectance(double n, double k, double cosine);

/// Coefficient a of F = Schlick - a cos (1 - cos)^6 that makes F at cos = 1/7 (82 degrees) `edgeTint` times
/// Schlick's, per channel (Kutz, Hasan & Edmondson, "Novel aspects of the Adobe Standard Material", 2021).
glm::vec3 f82Coefficient(const glm::vec3& f0, const glm::vec3& edgeTint);

/// Share of even light that enters a smooth dielectric of index `ior` >= 1 (Walsh 1926; Duntley, J. Opt. Soc.
/// Am. 32, 1942). From within, ior^2 times less leaves.
double meanTransmittance(double ior);

}  // namespace steradian
