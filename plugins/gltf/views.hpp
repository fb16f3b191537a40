// SPDX-License-Identifier: MIT
// Buffer views and accessors read with every offset, stride and count checked before a byte is touched.
#pragma once
#include <glm/glm.hpp>

#include "document.hpp"

namespace gltf {

/// The bytes of `bufferView`. Throws BadInput "bufferViews[1].byteLength: ..." when they leave its buffer.
std::string_view bytesOfView(const Document& document, std::size_t bufferView);
std::string_view bytesWithin(std::string_view buffer, std::uint64_t offset, std::uint64_t length,
                             const std::string& place);

/// What an attribute may be made of.
struct Wanted {
  std::string what;  // "POSITION", for messages
  int leastComponents, mostComponents;
  std::size_t count = 0;  // 0 = any
};

/// The elements of an accessor, sparse ones put in: `components` numbers each, integers as they are or, where
/// the accessor says normalized, in [0, 1] or [-1, 1]. Not checked for finiteness. Throws BadInput with the
/// place.
struct Numbers {
  int components = 0;
  std::vector<float> values;
  std::size_t count() const { return components ? values.size() / std::size_t(components) : 0; }
};
Numbers readNumbers(const Document& document, int accessor, const Wanted& wanted);

/// Unsigned integers: indices of vertices, joints.
std::vector<std::uint32_t> readIntegers(const Document& document, int accessor, const Wanted& wanted);

/// Throws BadInput naming the first element that is infinite, not a number or beyond 1e12.
void demandFinite(const Numbers& numbers, int accessor, const std::string& what);

template <class Vector>
std::vector<Vector> vectorsOf(const Numbers& numbers) {
  static_assert(sizeof(Vector) == sizeof(float) * std::size_t(Vector::length()));
  std::vector<Vector> out(numbers.count());
  if (!out.empty())
    std::memcpy(static_cast<void*>(out.data()), numbers.values.data(), out.size() * sizeof(Vector));
  return out;
}

}  // namespace gltf
