// SPDX-License-Identifier: MIT
// Writing the four-float rows that the device reads.
#pragma once
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>

namespace steradian {

inline glm::vec4 row(const glm::dvec3& v, double w) {
  return glm::vec4(glm::vec3(v), float(w));
}

/// A float with the bits of a word, for numbers that travel among floats.
inline float bits(std::uint32_t word) {
  return std::bit_cast<float>(word);
}

}  // namespace steradian
