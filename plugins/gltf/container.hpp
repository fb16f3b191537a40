// SPDX-License-Identifier: MIT
// The outermost layer: .glb chunks or plain text, and JSON that is safe to build a tree of.
#pragma once
#include "document.hpp"

namespace gltf {

inline constexpr int kDeepest = 60;  // what is kept must fit a project, whose limit is 64
inline constexpr std::uint64_t kLongestJson = 512ull << 20;  // bytes

struct Container {
  std::string_view text;    // the JSON
  std::string_view binary;  // the BIN chunk of a .glb
  bool hasBinary = false;
};

/// Throws BadInput naming the chunk.
Container splitContainer(std::string_view file);

/// Of duplicate keys the last counts; a byte order mark is skipped. Throws BadInput "line 3, column 7: ...",
/// and for text that is nested deeper than kDeepest before any of it is parsed.
Json parseJson(std::string_view text);

}  // namespace gltf
