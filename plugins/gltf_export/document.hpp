// SPDX-License-Identifier: MIT
// A glTF document in the making: the JSON, and one binary buffer that its accessors view.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace gltf_export {

using Json = nlohmann::ordered_json;

enum class Target { none = 0, vertices = 34962, indices = 34963 };  // bufferView.target

/// Indices into the document's arrays are in the order of the calls.
class Document {
 public:
  /// `components`: 1..4 floats per element; `bounds`: write min and max, as positions and key times must.
  std::size_t addFloats(std::span<const float> values, int components, Target target, bool bounds = false);
  std::size_t addIndices(std::span<const std::uint32_t> values);
  /// The bytes of a file, without an accessor.
  std::size_t addBytes(std::span<const std::uint8_t> bytes);
  /// Appends to a top-level array such as "nodes"; the index it got.
  std::size_t append(const char* array, Json value);
  void use(const std::string& extension) { extensions_.insert(extension); }

  Json& root() { return root_; }
  /// A JSON text whose buffer has this uri, or none for the second chunk of a .glb.
  std::string text(const std::string& bufferUri);
  const std::vector<std::uint8_t>& buffer() const { return buffer_; }

 private:
  std::size_t addView(std::span<const std::uint8_t> bytes, Target target);

  Json root_ = Json::object();
  std::vector<std::uint8_t> buffer_;
  std::set<std::string> extensions_;
};

}  // namespace gltf_export
