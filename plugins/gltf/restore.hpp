// SPDX-License-Identifier: MIT
// What Steradian's own exporter wrote beside glTF, under extras.steradian: shapes, lights and keys as they
// were.
#pragma once
#include <optional>

#include "document.hpp"

namespace gltf {

/// extras.steradian of an element, {} when there is none.
Json oursOf(const std::string& extrasJson);

struct OwnObject {
  sdk::ObjectRecord record;     // kind and its fields
  std::string imageFile;        // record points to it when written
  bool analytic = false;        // replaces the mesh that stands for it
  std::optional<int> material;  // glTF's index
};

/// Reads over `start`, which is what glTF itself said. Throws BadInput "extras.steradian.radius: expected
/// ...".
OwnObject restoreObject(const Json& ours, const sdk::ObjectRecord& start, std::size_t materials);

struct OwnChannel {
  std::size_t node = 0;
  std::uint32_t property = 0, interpolation = 1;
  std::vector<sdk::Key> keys;
};

/// Throws BadInput. Nodes are below `nodes`; keys are sound for any target.
std::vector<OwnChannel> restoreChannels(const Json& ours, std::size_t nodes);

}  // namespace gltf
