// SPDX-License-Identifier: MIT
// The header of a PLY file: which elements with which properties follow.
#include "header.hpp"

#include <charconv>

namespace ply {

namespace sdk = steradian::sdk;

namespace {

constexpr std::uint64_t kMostRows = (std::uint64_t(1) << 31) - 1;
constexpr std::size_t kMostElements = 64, kMostProperties = 256;

constexpr struct {
  const char *name, *alias;
  Type type;
  std::size_t size;
} kTypes[] = {{"char", "int8", Type::int8, 1},        {"uchar", "uint8", Type::uint8, 1},
              {"short", "int16", Type::int16, 2},     {"ushort", "uint16", Type::uint16, 2},
              {"int", "int32", Type::int32, 4},       {"uint", "uint32", Type::uint32, 4},
              {"float", "float32", Type::float32, 4}, {"double", "float64", Type::float64, 8}};

class Parser {
 public:
  explicit Parser(std::string_view bytes) : bytes_(bytes) {}

  Header parse() {
    if (next() != "ply") fail("expected 'ply'; is this a PLY file?");
    while (true) {
      Words words{next()};
      const std::string_view key = words.next();
      if (key == "end_header") break;
      statement(key, words);
    }
    if (!format_) fail("the header has no format");
    header_.size = at_;
    checkSizes();
    return std::move(header_);
  }

 private:
  struct Words {
    std::string_view line;
    std::string_view next() {
      line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
      const std::string_view word = line.substr(0, line.find_first_of(" \t"));
      line.remove_prefix(word.size());
      return word;
    }
  };

  [[noreturn]] void fail(const std::string& what) const {
    throw sdk::BadInput("line " + std::to_string(line_) + ": " + what);
  }
  static std::string quoted(std::string_view word) {
    return std::string("'").append(word.substr(0, 40)).append("'");
  }

  std::string_view next() {
    ++line_;
    const std::size_t end = bytes_.find('\n', at_);
    if (end == bytes_.npos || line_ > 10000) fail("the header does not end; expected 'end_header'");
    std::string_view line = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    while (line.ends_with('\r') || line.ends_with(' ')) line.remove_suffix(1);
    return line;
  }

  void statement(std::string_view key, Words& words) {
    if (key == "format") return format(words);
    if (key == "element") return element(words);
    if (key == "property") return property(words);
    if (key != "comment" && key != "obj_info" && !key.empty())
      fail("expected element or property, got " + quoted(key));
  }

  void format(Words& words) {
    const std::string_view name = words.next(), version = words.next();
    header_.format = name == "ascii"                  ? Header::Format::ascii
                     : name == "binary_little_endian" ? Header::Format::littleEndian
                                                      : Header::Format::bigEndian;
    if ((header_.format == Header::Format::bigEndian && name != "binary_big_endian") || version != "1.0")
      fail("expected ascii, binary_little_endian or binary_big_endian 1.0, got " + quoted(name) + " " +
           quoted(version));
    format_ = true;
  }

  void element(Words& words) {
    Element& out = header_.elements.emplace_back();
    out.name = words.next();
    const std::string_view count = words.next();
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), out.count);
    if (error != std::errc() || end != count.data() + count.size() || out.count > kMostRows)
      fail("expected how many " + quoted(out.name) + " there are, at most 2^31 - 1, got " + quoted(count));
    if (header_.elements.size() > kMostElements) fail("expected at most 64 elements");
  }

  void property(Words& words) {
    if (header_.elements.empty()) fail("expected an element before its properties");
    auto& properties = header_.elements.back().properties;
    Property& out = properties.emplace_back();
    std::string_view type = words.next();
    out.list = type == "list";
    if (out.list) out.countType = typeOf(words.next());
    if (out.list && isFloat(out.countType)) fail("expected a whole number as the length of a list");
    out.type = typeOf(out.list ? words.next() : type);
    out.name = words.next();
    if (properties.size() > kMostProperties) fail("expected at most 256 properties");
  }

  Type typeOf(std::string_view name) const {
    for (const auto& each : kTypes)
      if (name == each.name || name == each.alias) return each.type;
    fail("expected a type such as float or uchar, got " + quoted(name));
  }

  void checkSizes() const {
    std::uint64_t least = 0;
    for (const Element& element : header_.elements) {
      std::uint64_t row = 0;
      for (const Property& p : element.properties)
        row += header_.format == Header::Format::ascii ? 2 : sizeOf(p.list ? p.countType : p.type);
      least += element.count * row;
    }
    const std::uint64_t there = bytes_.size() - header_.size + 1;  // the last line may lack its end
    if (least > there)
      fail("the elements take at least " + std::to_string(least) + " bytes, and " +
           std::to_string(there - 1) + " follow the header; the file is cut off or damaged");
  }

  std::string_view bytes_;
  std::size_t at_ = 0, line_ = 0;
  bool format_ = false;
  Header header_;
};

}  // namespace

std::size_t sizeOf(Type type) {
  return kTypes[std::size_t(type)].size;
}

Header parseHeader(std::string_view bytes) {
  return Parser(bytes).parse();
}

}  // namespace ply
