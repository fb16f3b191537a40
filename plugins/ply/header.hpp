// SPDX-License-Identifier: MIT
// The header of a PLY file: which elements with which properties follow.
#pragma once
#include <cstdint>
#include <steradian/plugin.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ply {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t sizeOf(Type type);
inline bool isFloat(Type type) {
  return type == Type::float32 || type == Type::float64;
}

struct Property {
  std::string name;
  Type type = Type::float32;
  bool list = false;
  Type countType = Type::uint8;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  enum class Format { ascii, littleEndian, bigEndian };
  Format format = Format::ascii;
  std::vector<Element> elements;
  std::size_t size = 0;  // bytes, with the line end of end_header
};

/// Every element fits the bytes that follow, as short as its rows may be: memory may be taken for its count.
/// Throws BadInput naming the line.
Header parseHeader(std::string_view bytes);

}  // namespace ply
