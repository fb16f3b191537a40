// SPDX-License-Identifier: MIT
// The values after a PLY header, one by one, whatever their encoding.
#pragma once
#include "header.hpp"

namespace ply {

class Values {
 public:
  Values(const Header& header, std::string_view bytes)
      : format_(header.format), bytes_(bytes), at_(header.size) {}

  /// For messages: what is read next.
  void enter(const Element& element, std::uint64_t row) { element_ = &element, row_ = row; }

  /// The next value. Throws BadInput naming element and row when there is none.
  double next(Type type);
  /// The length of a list, at most what may follow.
  std::uint64_t length(const Property& list);
  void skip(const Property& property);
  [[noreturn]] void fail(const std::string& what) const;
  double progress() const { return double(at_) / double(bytes_.size()); }

 private:
  double nextWord();

  Header::Format format_;
  std::string_view bytes_;
  std::size_t at_;
  const Element* element_ = nullptr;
  std::uint64_t row_ = 0;
};

}  // namespace ply
