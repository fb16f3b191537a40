// SPDX-License-Identifier: MIT
// A text file line by line, and a line word by word.
#pragma once
#include <algorithm>
#include <cmath>
#include <steradian/plugin.hpp>
#include <steradian/polygon.hpp>
#include <string>
#include <string_view>

namespace obj {

/// Lines with their numbers; one that ends in a backslash goes on in the next.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  /// False at the end. The line is valid until the next call and has no line end.
  bool next(std::string_view& line) {
    if (at_ >= text_.size()) return false;
    line = physical();
    if (!line.ends_with('\\')) return true;
    joined_.clear();
    while (line.ends_with('\\') && at_ < text_.size()) {
      joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
      line = physical();
    }
    joined_.append(line);
    line = joined_;
    return true;
  }
  std::size_t number() const { return number_; }
  std::size_t position() const { return at_; }

 private:
  std::string_view physical() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1;
    ++number_;
    while (line.ends_with('\r') || line.ends_with(' ') || line.ends_with('\t')) line.remove_suffix(1);
    return line;
  }

  std::string_view text_;
  std::string joined_;
  std::size_t at_ = 0, number_ = 0;
};

/// The words of a line up to a comment.
class Words {
 public:
  explicit Words(std::string_view line) : line_(line) {}

  std::string_view next() {
    skipBlanks();
    if (line_.starts_with('#')) line_ = {};
    const std::string_view word = line_.substr(0, std::min(line_.find_first_of(" \t"), line_.size()));
    line_.remove_prefix(word.size());
    return word;
  }
  /// All that is left: names may hold spaces.
  std::string_view rest() {
    skipBlanks();
    return line_;
  }

 private:
  void skipBlanks() { line_.remove_prefix(std::min(line_.find_first_not_of(" \t"), line_.size())); }

  std::string_view line_;
};

[[noreturn]] inline void failAt(std::size_t line, const std::string& what) {
  throw steradian::sdk::BadInput("line " + std::to_string(line) + ": " + what);
}

/// A word for a message: short, whatever the file holds.
inline std::string quoted(std::string_view word) {
  return std::string("'").append(word.substr(0, 40)).append(word.size() > 40 ? "...'" : "'");
}

/// How many bytes the UTF-8 character at the start of `text` has; 0 when there is none.
inline std::size_t characterSize(std::string_view text) {
  const auto byte = [&](std::size_t i) { return std::uint32_t(static_cast<unsigned char>(text[i])); };
  const std::size_t size = byte(0) < 0x80   ? 1
                           : byte(0) < 0xc2 ? 0
                           : byte(0) < 0xe0 ? 2
                           : byte(0) < 0xf0 ? 3
                                            : 4;
  if (size < 2) return size;
  if (text.size() < size) return 0;
  std::uint32_t code = byte(0) & (0x7fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3f);
  }
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return code < (size == 3   ? 0x800u
                 : size == 4 ? 0x10000u
                             : 0x80u) ||
                 code > 0x10ffff || surrogate
             ? 0
             : size;
}

/// A name as UTF-8; old files hold Latin-1.
inline std::string utf8Of(std::string_view name) {
  std::string out;
  while (!name.empty()) {
    const std::size_t size = characterSize(name);
    const auto byte = static_cast<unsigned char>(name[0]);
    if (size > 0)
      out.append(name.substr(0, size));
    else
      out.append({char(byte < 0xc0 ? 0xc2 : 0xc3), char(byte < 0xc0 ? byte : byte - 0x40)});
    name.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return out;
}

/// A number of at most 1e12, as everything in a scene.
inline float numberAt(std::size_t line, std::string_view word) {
  const auto value = steradian::sdk::numberIn(word);
  if (!value || !(std::abs(*value) <= 1e12))
    failAt(line, "expected a number of at most 1e12, got " + quoted(word));
  return float(*value);
}

}  // namespace obj
