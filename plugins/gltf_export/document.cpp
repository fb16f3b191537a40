// SPDX-License-Identifier: MIT
// A glTF document in the making: the JSON, and one binary buffer that its accessors view.
#include "document.hpp"

#include <algorithm>
#include <cstring>

namespace gltf_export {

namespace {

constexpr int kFloat = 5126, kUint32 = 5125;  // accessor.componentType
constexpr const char* kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};

template <class Number>
std::span<const std::uint8_t> bytesOf(std::span<const Number> values) {
  return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()};
}

}  // namespace

std::size_t Document::append(const char* array, Json value) {
  Json& list = root_[array];
  list.push_back(std::move(value));
  return list.size() - 1;
}

std::size_t Document::addView(std::span<const std::uint8_t> bytes, Target target) {
  while (buffer_.size() % 4 != 0)
    buffer_.push_back(0);  // accessors begin at multiples of their component size
  Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (target != Target::none) view["target"] = int(target);
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  return append("bufferViews", std::move(view));
}

std::size_t Document::addFloats(std::span<const float> values, int components, Target target, bool bounds) {
  const std::size_t count = values.size() / std::size_t(components);
  Json accessor = {{"bufferView", addView(bytesOf(values), target)},
                   {"componentType", kFloat},
                   {"count", count},
                   {"type", kTypes[components - 1]}};
  if (bounds) {
    std::vector<float> low(values.begin(), values.begin() + components), high = low;
    for (std::size_t i = 0; i < values.size(); ++i) {
      float &l = low[i % std::size_t(components)], &h = high[i % std::size_t(components)];
      l = std::min(l, values[i]);
      h = std::max(h, values[i]);
    }
    accessor["min"] = low;
    accessor["max"] = high;
  }
  return append("accessors", std::move(accessor));
}

std::size_t Document::addIndices(std::span<const std::uint32_t> values) {
  return append("accessors", {{"bufferView", addView(bytesOf(values), Target::indices)},
                              {"componentType", kUint32},
                              {"count", values.size()},
                              {"type", "SCALAR"}});
}

std::size_t Document::addBytes(std::span<const std::uint8_t> bytes) {
  return addView(bytes, Target::none);
}

std::string Document::text(const std::string& bufferUri) {
  Json document = {{"asset", {{"version", "2.0"}, {"generator", "Steradian"}}}};
  if (!extensions_.empty()) document["extensionsUsed"] = extensions_;
  if (!buffer_.empty()) {
    Json buffer = {{"byteLength", buffer_.size()}};
    if (!bufferUri.empty()) buffer["uri"] = bufferUri;
    document["buffers"] = Json::array({buffer});
  }
  document.update(root_);
  return document.dump(2);
}

}  // namespace gltf_export
