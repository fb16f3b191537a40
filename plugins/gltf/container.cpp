// SPDX-License-Identifier: MIT
// The outermost layer: .glb chunks or plain text, and JSON that is safe to build a tree of.
#include "container.hpp"

#include <algorithm>

namespace gltf {

namespace {

constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t word(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;  // little-endian, as glTF and every machine that we build for
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

struct Chunk {
  std::uint32_t type = 0;
  std::string_view bytes;
};

/// The chunk at `offset`, which moves behind it.
Chunk nextChunk(std::string_view file, std::size_t& offset, const std::string& place) {
  if (file.size() - offset < 8)
    throw sdk::BadInput(place + ": expected a header of 8 bytes, got " +
                        std::to_string(file.size() - offset));
  const std::uint64_t length = word(file, offset);
  const std::uint32_t type = word(file, offset + 4);
  offset += 8;
  if (length > file.size() - offset)
    throw sdk::BadInput(place + ": expected " + std::to_string(length) + " bytes, got " +
                        std::to_string(file.size() - offset) + "; the file is cut short");
  const Chunk chunk{type, file.substr(offset, length)};
  offset += length;
  return chunk;
}

Container splitBinary(std::string_view file) {
  if (file.size() < 12) throw sdk::BadInput("header: expected 12 bytes, got " + std::to_string(file.size()));
  if (word(file, 4) != 2)
    throw sdk::BadInput("header.version: expected 2, got " + std::to_string(word(file, 4)));
  const std::uint32_t length = word(file, 8);
  if (length > file.size() || length < 12)
    throw sdk::BadInput("header.length: expected " + std::to_string(file.size()) +
                        ", the size of the file, got " + std::to_string(length) +
                        (length > file.size() ? "; the file is cut short" : ""));
  file = file.substr(0, length);
  std::size_t offset = 12;
  const Chunk json = nextChunk(file, offset, "chunk 0");
  if (json.type != kJsonChunk) throw sdk::BadInput("chunk 0: expected the type JSON");
  Container out{json.bytes, {}, false};
  for (int i = 1; offset < file.size(); ++i) {  // chunks of unknown types are to be skipped
    const Chunk chunk = nextChunk(file, offset, "chunk " + std::to_string(i));
    if (chunk.type != kBinaryChunk || out.hasBinary) continue;
    out.binary = chunk.bytes;
    out.hasBinary = true;
  }
  return out;
}

std::string placeOf(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, std::min(text.size(), position > 0 ? position - 1 : 0));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const auto lineStart = before.rfind('\n');
  const auto column = before.size() - (lineStart == before.npos ? 0 : lineStart + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column) + ": ";
}

/// Counts brackets outside of texts: whatever parses or frees the tree later may then use its stack.
void refuseDeepNesting(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kDeepest)
        throw sdk::BadInput(placeOf(text, i + 1) + "is nested deeper than " + std::to_string(kDeepest) +
                            " brackets");
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

}  // namespace

Container splitContainer(std::string_view file) {
  if (file.empty()) throw sdk::BadInput("is empty; expected a glTF 2.0 file");
  if (file.substr(0, 4) == "glTF") return splitBinary(file);
  return {file, {}, false};
}

Json parseJson(std::string_view text) {
  if (text.size() > kLongestJson) throw sdk::BadInput("has more than 512 MiB of JSON");
  refuseDeepNesting(text);
  Json json;
  try {
    json = Json::parse(text.begin(), text.end());
  } catch (const Json::parse_error& error) {
    std::string what = error.what();
    what.erase(0, what.find("] ") + 2);  // [json.exception.parse_error.101]
    if (what.rfind("parse error at line", 0) == 0) what.erase(0, what.find(": ", what.find("column ")) + 2);
    throw sdk::BadInput(placeOf(text, error.byte) + what);
  } catch (const Json::exception& error) {  // numbers beyond double
    throw sdk::BadInput(std::string("is no sound JSON: ") + error.what());
  }
  if (!json.is_object()) throw sdk::BadInput("expected a JSON object {...}; is this a glTF file?");
  return json;
}

}  // namespace gltf
