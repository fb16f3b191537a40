// SPDX-License-Identifier: MIT
// Buffer views and accessors read with every offset, stride and count checked before a byte is touched.
#include "views.hpp"

#include <cmath>

namespace gltf {

namespace {

constexpr std::uint64_t kMostNumbers = std::uint64_t(1) << 33;  // of one accessor

/// A run of equally spaced elements that is known to lie inside its bytes.
struct Run {
  std::string_view bytes;
  std::uint64_t stride;
};

std::uint64_t componentSize(int componentType) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

/// `count` elements of `size` bytes at `offset` of a view; the arithmetic cannot wrap.
Run runWithin(const Document& document, int view, std::uint64_t offset, std::uint64_t count,
              std::uint64_t size, bool strided, const std::string& place) {
  if (view < 0) throw sdk::BadInput(place + ".bufferView: expected one");
  const std::string_view bytes = bytesOfView(document, std::size_t(view));
  const std::uint64_t given = strided ? document.model.bufferViews[std::size_t(view)].byteStride : 0;
  const std::uint64_t stride = given ? given : size;
  if (stride < size)
    throw sdk::BadInput(at("bufferViews", std::size_t(view)) + ".byteStride: expected at least the " +
                        std::to_string(size) + " bytes of an element of " + place + ", got " +
                        std::to_string(stride));
  if (offset > bytes.size())
    throw sdk::BadInput(place + ".byteOffset: expected at most " + std::to_string(bytes.size()) +
                        ", the length of its view, got " + std::to_string(offset));
  const std::uint64_t left = bytes.size() - offset;
  const std::uint64_t fit = left < size ? 0 : (left - size) / stride + 1;
  if (count > fit)
    throw sdk::BadInput(place + ".count: expected at most " + std::to_string(fit) +
                        ", what its view holds, got " + std::to_string(count));
  return {bytes.substr(offset), stride};
}

template <class Component>
Component load(const char* at) {
  Component value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// glTF 2.0, 3.6.2.2: signed integers are normalized so that -128 and -127 both mean -1.
template <class Component, class Number>
Number convert(Component value, bool normalized) {
  if constexpr (std::is_floating_point_v<Number> && std::is_integral_v<Component>)
    if (normalized)
      return std::max(Number(value) / Number(std::numeric_limits<Component>::max()), Number(-1));
  return Number(value);
}

template <class Component, class Number>
void copyElements(const Run& run, std::size_t count, int components, bool normalized, Number* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const char* from = run.bytes.data() + i * run.stride;
    for (int c = 0; c < components; ++c)
      *out++ =
          convert<Component, Number>(load<Component>(from + std::size_t(c) * sizeof(Component)), normalized);
  }
}

template <class Number>
void copyElements(int type, const Run& run, std::size_t count, int components, bool normalized, Number* out) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return copyElements<std::int8_t>(run, count, components, normalized, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copyElements<std::uint8_t>(run, count, components, normalized, out);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return copyElements<std::int16_t>(run, count, components, normalized, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copyElements<std::uint16_t>(run, count, components, normalized, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copyElements<std::uint32_t>(run, count, components, normalized, out);
    default:
      if constexpr (std::is_floating_point_v<Number>)
        return copyElements<float>(run, count, components, normalized, out);
  }
}

template <class Number>
void putSparse(const Document& document, const tinygltf::Accessor& accessor, const std::string& place,
               int components, std::vector<Number>& out) {
  const auto& sparse = accessor.sparse;
  const auto count = std::size_t(sparse.count);
  if (sparse.count < 0 || count > accessor.count)
    throw sdk::BadInput(place + ".sparse.count: expected at most " + std::to_string(accessor.count) +
                        ", got " + std::to_string(sparse.count));
  const std::uint64_t indexSize = sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_SHORT
                                      ? 0
                                      : componentSize(sparse.indices.componentType);
  if (indexSize == 0)
    throw sdk::BadInput(place + ".sparse.indices.componentType: expected 5121, 5123 or 5125");
  const Run indexRun =
      runWithin(document, sparse.indices.bufferView, std::uint64_t(sparse.indices.byteOffset), count,
                indexSize, false, place + ".sparse.indices");
  const Run valueRun = runWithin(document, sparse.values.bufferView, std::uint64_t(sparse.values.byteOffset),
                                 count, componentSize(accessor.componentType) * std::uint64_t(components),
                                 false, place + ".sparse.values");
  std::vector<std::uint32_t> indices(count);
  copyElements(sparse.indices.componentType, indexRun, count, 1, false, indices.data());
  std::vector<Number> values(count * std::size_t(components));
  copyElements(accessor.componentType, valueRun, count, components, accessor.normalized, values.data());
  for (std::size_t i = 0; i < count; ++i) {
    if (indices[i] >= accessor.count)
      throw sdk::BadInput(place + ".sparse.indices: expected indices below " +
                          std::to_string(accessor.count) + ", got " + std::to_string(indices[i]));
    std::copy_n(values.begin() + std::ptrdiff_t(i * std::size_t(components)), components,
                out.begin() + std::ptrdiff_t(std::size_t(indices[i]) * std::size_t(components)));
  }
}

/// Checks the accessor against what is wanted of it and gives its elements; `components` is how many each
/// has.
template <class Number>
std::vector<Number> read(const Document& document, int index, const Wanted& wanted, int& components) {
  const std::string place = at("accessors", std::size_t(index));
  document.demand(place);
  const tinygltf::Accessor& accessor = document.model.accessors[std::size_t(index)];
  components = tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type));
  if (components < wanted.leastComponents || components > wanted.mostComponents)
    throw sdk::BadInput(place + ".type: expected " + std::to_string(wanted.leastComponents) + " to " +
                        std::to_string(wanted.mostComponents) + " components for " + wanted.what + ", got " +
                        std::to_string(components));
  const std::uint64_t size = componentSize(accessor.componentType);
  const bool whole = std::is_integral_v<Number>;
  const bool isSigned = accessor.componentType == TINYGLTF_COMPONENT_TYPE_BYTE ||
                        accessor.componentType == TINYGLTF_COMPONENT_TYPE_SHORT;
  if (size == 0 || (whole && (isSigned || accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT)))
    throw sdk::BadInput(place + ".componentType: " + std::to_string(accessor.componentType) +
                        " does not fit " + wanted.what);
  if (wanted.count && accessor.count != wanted.count)
    throw sdk::BadInput(place + ".count: expected " + std::to_string(wanted.count) + " for " + wanted.what +
                        ", got " + std::to_string(accessor.count));
  const Run run = runWithin(document, accessor.bufferView, accessor.byteOffset, accessor.count,
                            size * std::uint64_t(components), true, place);
  if (accessor.count > kMostNumbers / std::uint64_t(components))
    throw sdk::BadInput(place + ".count: " + std::to_string(accessor.count) + " is more than fits memory");
  std::vector<Number> out(accessor.count * std::size_t(components));
  copyElements(accessor.componentType, run, accessor.count, components, accessor.normalized, out.data());
  if (accessor.sparse.isSparse) putSparse(document, accessor, place, components, out);
  return out;
}

}  // namespace

std::string_view bytesWithin(std::string_view buffer, std::uint64_t offset, std::uint64_t length,
                             const std::string& place) {
  if (offset > buffer.size() || length > buffer.size() - offset)
    throw sdk::BadInput(place + ": expected bytes inside its buffer of " + std::to_string(buffer.size()) +
                        ", got offset " + std::to_string(offset) + " and length " + std::to_string(length));
  return buffer.substr(offset, length);
}

std::string_view bytesOfView(const Document& document, std::size_t index) {
  const std::string place = at("bufferViews", index);
  document.demand(place);
  const tinygltf::BufferView& view = document.model.bufferViews[index];
  return bytesWithin(document.buffers[std::size_t(view.buffer)], view.byteOffset, view.byteLength, place);
}

Numbers readNumbers(const Document& document, int accessor, const Wanted& wanted) {
  Numbers out;
  out.values = read<float>(document, accessor, wanted, out.components);
  return out;
}

std::vector<std::uint32_t> readIntegers(const Document& document, int accessor, const Wanted& wanted) {
  int components = 0;
  return read<std::uint32_t>(document, accessor, wanted, components);
}

void demandFinite(const Numbers& numbers, int accessor, const std::string& what) {
  for (std::size_t i = 0; i < numbers.values.size(); ++i)
    if (!(std::abs(numbers.values[i]) <= 1e12f))
      throw sdk::BadInput(at("accessors", std::size_t(accessor)) +
                          ": expected finite numbers up to 1e12 for " + what + ", got " +
                          std::to_string(numbers.values[i]) + " in element " +
                          std::to_string(i / std::size_t(numbers.components)));
}

}  // namespace gltf
