// SPDX-License-Identifier: MIT
// The values after a PLY header, one by one, whatever their encoding.
#include "elements.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <steradian/polygon.hpp>

namespace ply {

namespace sdk = steradian::sdk;

namespace {

static_assert(std::endian::native == std::endian::little);

template <class Number>
double numberAt(const char* bytes, bool swap) {
  char ordered[sizeof(Number)];
  std::memcpy(ordered, bytes, sizeof ordered);
  if (swap) std::reverse(ordered, ordered + sizeof ordered);
  Number value;
  std::memcpy(&value, ordered, sizeof value);
  return double(value);
}

}  // namespace

void Values::fail(const std::string& what) const {
  throw sdk::BadInput(element_->name.substr(0, 40) + " " + std::to_string(row_) + ": " + what);
}

double Values::nextWord() {
  constexpr std::string_view kBlanks = " \t\r\n";
  at_ = std::min(bytes_.find_first_not_of(kBlanks, at_), bytes_.size());
  const std::size_t end = std::min(bytes_.find_first_of(kBlanks, at_), bytes_.size());
  const std::string_view word = bytes_.substr(at_, end - at_);
  if (word.empty()) fail("the file ends here");
  at_ = end;
  const auto value = sdk::numberIn(word);
  if (!value) fail("expected a number, got '" + std::string(word.substr(0, 40)) + "'");
  return *value;
}

double Values::next(Type type) {
  if (format_ == Header::Format::ascii) return nextWord();
  if (bytes_.size() - at_ < sizeOf(type)) fail("the file ends here");
  const char* here = bytes_.data() + at_;
  at_ += sizeOf(type);
  const bool swap = format_ == Header::Format::bigEndian;
  switch (type) {
    case Type::int8:
      return numberAt<std::int8_t>(here, swap);
    case Type::uint8:
      return numberAt<std::uint8_t>(here, swap);
    case Type::int16:
      return numberAt<std::int16_t>(here, swap);
    case Type::uint16:
      return numberAt<std::uint16_t>(here, swap);
    case Type::int32:
      return numberAt<std::int32_t>(here, swap);
    case Type::uint32:
      return numberAt<std::uint32_t>(here, swap);
    case Type::float32:
      return numberAt<float>(here, swap);
    case Type::float64:
      break;
  }
  return numberAt<double>(here, swap);
}

std::uint64_t Values::length(const Property& list) {
  const double length = next(list.countType);
  const double most =
      double(bytes_.size() - at_ + 1) / (format_ == Header::Format::ascii ? 2.0 : double(sizeOf(list.type)));
  if (!(length >= 0) || length != std::floor(length) || length > most)
    fail("its list '" + list.name.substr(0, 40) + "' claims a length that does not fit the rest of the file");
  return std::uint64_t(length);
}

void Values::skip(const Property& property) {
  const std::uint64_t count = property.list ? length(property) : 1;
  for (std::uint64_t i = 0; i < count; ++i) next(property.type);
}

}  // namespace ply
