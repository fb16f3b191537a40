// SPDX-License-Identifier: MIT
// Compressed content made plain, before anything looks at it: EXT_meshopt_compression,
// KHR_draco_mesh_compression.
#include "decompress.hpp"

#include <meshoptimizer.h>

#include <set>

#include "views.hpp"

namespace gltf {

namespace {

constexpr const char* kMeshopt = "EXT_meshopt_compression";
constexpr const char* kDraco = "KHR_draco_mesh_compression";
constexpr std::uint64_t kMostZeros = 64ull << 20;

const Json* extensionOf(const Json& json, const char* name) {
  const auto extensions = json.find("extensions");
  if (extensions == json.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(name);
  return found == extensions->end() || !found->is_object() ? nullptr : &*found;
}

/// The libraries assert what this checks. No codec of theirs gets near the ratio that stops a bomb.
std::uint64_t checkedSize(const Json& e, std::size_t compressed, const std::string& place) {
  const auto count = e["count"].get<std::uint64_t>(), stride = e["byteStride"].get<std::uint64_t>();
  const std::string mode = e["mode"], filter = e.value("filter", "NONE");
  const bool attributes = mode == "ATTRIBUTES";
  if (attributes ? stride % 4 != 0 : stride != 2 && stride != 4)
    throw sdk::BadInput(place + ".byteStride: " + std::to_string(stride) + " does not fit the mode " + mode);
  if (mode == "TRIANGLES" && count % 3 != 0)
    throw sdk::BadInput(place + ".count: expected a multiple of 3, got " + std::to_string(count));
  const bool octahedral = filter == "OCTAHEDRAL" && stride != 4 && stride != 8;
  if (filter != "NONE" && (!attributes || octahedral || (filter == "QUATERNION" && stride != 8)))
    throw sdk::BadInput(place + ".filter: " + filter + " does not fit the mode and stride");
  if (count > (std::uint64_t(compressed) * 1024 + 65536) / stride)
    throw sdk::BadInput(place + ".count: " + std::to_string(count) + " elements cannot come from " +
                        std::to_string(compressed) + " bytes");
  return count * stride;
}

void applyFilter(const std::string& filter, std::string& bytes, std::size_t count, std::size_t stride) {
  if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), count, stride);
  if (filter == "QUATERNION") meshopt_decodeFilterQuat(bytes.data(), count, stride);
  if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), count, stride);
}

std::string decodeMeshopt(const Json& e, const std::string& place, const Document& document) {
  const std::string_view source =
      bytesWithin(document.buffers[e["buffer"].get<std::size_t>()], e.value("byteOffset", std::uint64_t(0)),
                  e["byteLength"], place);
  std::string out(checkedSize(e, source.size(), place), '\0');
  const std::size_t count = e["count"], stride = e["byteStride"];
  const auto* bytes = reinterpret_cast<const unsigned char*>(source.data());
  const std::string mode = e["mode"];
  const int failed =
      mode == "ATTRIBUTES"  ? meshopt_decodeVertexBuffer(out.data(), count, stride, bytes, source.size())
      : mode == "TRIANGLES" ? meshopt_decodeIndexBuffer(out.data(), count, stride, bytes, source.size())
                            : meshopt_decodeIndexSequence(out.data(), count, stride, bytes, source.size());
  if (failed) throw sdk::BadInput(place + ": the compressed data are damaged");
  applyFilter(e.value("filter", "NONE"), out, count, stride);
  return out;
}

/// Points the view at its decoded bytes; its stride stays.
void plainView(Json& json, std::size_t index, Document& document) {
  const Json* extension = extensionOf(json["bufferViews"][index], kMeshopt);
  if (!extension || document.unsound.count(at("bufferViews", index))) return;
  const std::string place = at("bufferViews", index) + ".extensions." + kMeshopt;
  try {
    document.decoded.push_back(decodeMeshopt(*extension, place, document));
    document.buffers.push_back(document.decoded.back());
    Json& view = json["bufferViews"][index];
    view["buffer"] = document.buffers.size() - 1;
    view["byteOffset"] = 0;
    view["byteLength"] = document.buffers.back().size();
  } catch (const sdk::BadInput& error) {
    document.unsound.emplace(at("bufferViews", index), error.what());
  }
}

/// The accessors of a compressed primitive describe it, but hold nothing themselves.
void plainPrimitive(Json& json, Json& primitive, const std::string& place, Document& document,
                    std::set<std::size_t>& descriptions) {
  if (!extensionOf(primitive, kDraco)) return;
  for (const auto& attribute : primitive["attributes"]) descriptions.insert(attribute.get<std::size_t>());
  if (primitive.contains("indices")) descriptions.insert(primitive["indices"].get<std::size_t>());
  try {
    decodeDraco(json, primitive, place, document);
  } catch (const sdk::BadInput& error) {
    document.unsound.emplace(place, error.what());
    primitive["attributes"] = Json::object();
    primitive.erase("indices");
  }
}

void plainPrimitives(Json& json, Document& document, std::set<std::size_t>& descriptions) {
  if (!json.contains("meshes")) return;
  for (std::size_t m = 0; m < json["meshes"].size(); ++m) {
    if (!json["meshes"][m].contains("primitives")) continue;
    Json& primitives = json["meshes"][m]["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p)
      plainPrimitive(json, primitives[p], at(at("meshes", m) + ".primitives", p), document, descriptions);
  }
}

std::uint64_t zerosOf(const Json& accessor) {
  static const std::map<std::string, std::uint64_t> kComponents = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
  const auto count = accessor["count"].get<std::uint64_t>();
  return std::min(count, kMostZeros) * 4 * kComponents.at(accessor["type"]);
}

void giveZeros(Json& json, Document& document, const std::set<std::size_t>& descriptions) {
  if (!json.contains("accessors")) return;
  std::uint64_t most = 0;
  std::vector<std::size_t> empty;
  for (std::size_t i = 0; i < json["accessors"].size(); ++i) {
    if (json["accessors"][i].contains("bufferView")) continue;
    empty.push_back(i);
    const std::uint64_t bytes = descriptions.count(i) ? 1 : zerosOf(json["accessors"][i]);
    if (bytes <= kMostZeros) most = std::max(most, bytes);  // larger ones fail as any that leaves its view
  }
  if (empty.empty()) return;
  const std::size_t view = addView(json, document, std::string(std::max<std::uint64_t>(most, 1), '\0'));
  for (const std::size_t i : empty) json["accessors"][i]["bufferView"] = view;
}

}  // namespace

std::size_t addView(Json& json, Document& document, std::string bytes) {
  document.buffers.push_back(document.decoded.emplace_back(std::move(bytes)));
  Json& views = json["bufferViews"];
  views.push_back({{"buffer", document.buffers.size() - 1}, {"byteLength", document.buffers.back().size()}});
  return views.size() - 1;
}

void decompress(Json& json, Document& document) {
  for (std::size_t i = 0; json.contains("bufferViews") && i < json["bufferViews"].size(); ++i)
    plainView(json, i, document);
  std::set<std::size_t> descriptions;
  plainPrimitives(json, document, descriptions);
  giveZeros(json, document, descriptions);
}

}  // namespace gltf
