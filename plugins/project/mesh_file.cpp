// SPDX-License-Identifier: MIT
// A mesh as the bytes of a .mesh file beside the project; README.md describes them.
#include "mesh_file.hpp"

#include <bit>
#include <charconv>
#include <cstring>
#include <utility>

namespace project {

namespace sdk = steradian::sdk;

namespace {

static_assert(std::endian::native == std::endian::little, "the arrays are written as they lie in memory");

constexpr char kMagic[8] = {'S', 'R', 'A', 'D', 'M', 'E', 'S', 'H'};
constexpr std::uint32_t kMeshVersion = 1;
constexpr std::uint64_t kMostElements = std::uint64_t(1) << 31;  // as the host takes

struct Header {
  char magic[8];
  std::uint32_t version;
  std::uint32_t attributes;  // bit i: the i-th optional array of kArrays is there
  std::uint64_t vertexCount;
  std::uint64_t triangleCount;
};
static_assert(sizeof(Header) == 32);

/// The optional arrays in the order of the file.
struct Optional {
  const float* sdk::MeshRecord::*data;
  std::uint64_t components;
};
constexpr Optional kOptional[] = {{&sdk::MeshRecord::normals, 3},
                                  {&sdk::MeshRecord::tangents, 4},
                                  {&sdk::MeshRecord::uv0, 2},
                                  {&sdk::MeshRecord::uv1, 2},
                                  {&sdk::MeshRecord::colors, 4}};

std::uint64_t sizeOf(const Header& h) {
  std::uint64_t components = 3;
  for (std::size_t i = 0; i < std::size(kOptional); ++i)
    if (h.attributes >> i & 1) components += kOptional[i].components;
  return sizeof(Header) + 4 * (h.vertexCount * components + h.triangleCount * 3);
}

Header checkedHeader(std::string_view bytes) {
  Header h{};
  if (bytes.size() < sizeof h || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0)
    throw sdk::BadInput("is no mesh file, or cut off within its first 32 bytes");
  std::memcpy(&h, bytes.data(), sizeof h);
  if (h.version != kMeshVersion)
    throw sdk::BadInput("is a mesh file of version " + std::to_string(h.version) +
                        "; this Steradian reads version 1");
  if (h.attributes >> std::size(kOptional))
    throw sdk::BadInput("says that it has attributes that mesh files do not have");
  if (h.vertexCount > kMostElements || h.triangleCount > kMostElements)
    throw sdk::BadInput("says that it has more than 2^31 vertices or triangles");
  if (bytes.size() != sizeOf(h))
    throw sdk::BadInput("has " + std::to_string(bytes.size()) + " bytes; its counts of " +
                        std::to_string(h.vertexCount) + " vertices and " + std::to_string(h.triangleCount) +
                        " triangles ask for " + std::to_string(sizeOf(h)));
  return h;
}

}  // namespace

std::string meshBytes(const sdk::MeshRecord& mesh) {
  Header h{{}, kMeshVersion, 0, mesh.vertexCount, mesh.triangleCount};
  std::memcpy(h.magic, kMagic, sizeof kMagic);
  for (std::size_t i = 0; i < std::size(kOptional); ++i)
    if (mesh.*kOptional[i].data) h.attributes |= 1u << i;
  std::string bytes;
  bytes.reserve(sizeOf(h));
  const auto put = [&](const void* data, std::uint64_t size) {
    if (size) bytes.append(static_cast<const char*>(data), size);
  };
  put(&h, sizeof h);
  put(mesh.positions, 12 * h.vertexCount);
  put(mesh.triangles, 12 * h.triangleCount);
  for (const Optional& each : kOptional)
    if (mesh.*each.data) put(mesh.*each.data, 4 * each.components * h.vertexCount);
  return bytes;
}

sdk::MeshRecord meshFrom(std::string_view bytes) {
  const Header h = checkedHeader(bytes);
  const char* at = bytes.data() + sizeof h;
  const auto take = [&](std::uint64_t size) { return std::exchange(at, at + size); };
  sdk::MeshRecord mesh{.vertexCount = h.vertexCount, .triangleCount = h.triangleCount};
  mesh.positions = reinterpret_cast<const float*>(take(12 * h.vertexCount));
  mesh.triangles = reinterpret_cast<const std::uint32_t*>(take(12 * h.triangleCount));
  for (std::size_t i = 0; i < std::size(kOptional); ++i)
    if (h.attributes >> i & 1)
      mesh.*kOptional[i].data =
          reinterpret_cast<const float*>(take(4 * kOptional[i].components * h.vertexCount));
  return mesh;
}

std::string contentHash(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  char digits[16];
  const auto written = std::to_chars(digits, digits + sizeof digits, hash, 16);
  const std::string text(digits, written.ptr);
  return std::string(16 - text.size(), '0') + text;
}

}  // namespace project
