// SPDX-License-Identifier: MIT
// KHR_draco_mesh_compression by Google's decoder.
#include <draco/compression/decode.h>

#include "decompress.hpp"
#include "views.hpp"

namespace gltf {

namespace {

std::unique_ptr<draco::Mesh> decode(std::string_view bytes, const std::string& place) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  const auto type = draco::Decoder::GetEncodedGeometryType(&buffer);
  if (!type.ok() || type.value() != draco::TRIANGULAR_MESH)
    throw sdk::BadInput(place + ": expected a Draco triangle mesh");
  draco::Decoder decoder;
  auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
  if (!mesh.ok()) throw sdk::BadInput(place + ": Draco says: " + mesh.status().error_msg_string());
  return std::move(mesh).value();
}

template <class Component>
std::string valuesOf(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int components,
                     const std::string& place) {
  std::vector<Component> out(std::size_t(mesh.num_points()) * std::size_t(components));
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i)
    if (!attribute.ConvertValue<Component>(attribute.mapped_index(draco::PointIndex(i)),
                                           std::int8_t(components),
                                           &out[std::size_t(i) * std::size_t(components)]))
      throw sdk::BadInput(place + ": expected a value for point " + std::to_string(i));
  return std::string(reinterpret_cast<const char*>(out.data()), out.size() * sizeof(Component));
}

std::string bytesOfAttribute(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int type,
                             const std::string& place) {
  const int components = attribute.num_components();
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return valuesOf<std::int8_t>(mesh, attribute, components, place);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return valuesOf<std::uint8_t>(mesh, attribute, components, place);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return valuesOf<std::int16_t>(mesh, attribute, components, place);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return valuesOf<std::uint16_t>(mesh, attribute, components, place);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return valuesOf<std::uint32_t>(mesh, attribute, components, place);
    default:
      return valuesOf<float>(mesh, attribute, components, place);
  }
}

std::size_t addAccessor(Json& json, Json accessor) {
  json["accessors"].push_back(std::move(accessor));
  return json["accessors"].size() - 1;
}

/// A plain accessor like the one that described the attribute, with the decoded values.
std::size_t plainAccessor(Json& json, Document& document, const draco::Mesh& mesh, int id,
                          std::size_t description, const std::string& place) {
  static constexpr const char* kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  document.demand(at("accessors", description));
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(std::uint32_t(id));
  if (!attribute || attribute->num_components() < 1 || attribute->num_components() > 4)
    throw sdk::BadInput(place + ": " + std::to_string(id) + " is no attribute of the compressed mesh");
  Json plain = json["accessors"][description];
  if (plain["type"] != kTypes[attribute->num_components() - 1])
    throw sdk::BadInput(place + ": expected " + plain["type"].get<std::string>() + ", got " +
                        std::to_string(int(attribute->num_components())) + " components");
  plain["bufferView"] =
      addView(json, document, bytesOfAttribute(mesh, *attribute, plain["componentType"], place));
  plain["byteOffset"] = 0;
  plain["count"] = mesh.num_points();
  plain.erase("sparse");
  return addAccessor(json, std::move(plain));
}

std::string bytesOfFaces(const draco::Mesh& mesh, const std::string& place) {
  std::vector<std::uint32_t> out;
  out.reserve(std::size_t(mesh.num_faces()) * 3);
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
    for (const draco::PointIndex& corner : mesh.face(f)) {
      if (corner.value() >= mesh.num_points())
        throw sdk::BadInput(place + ": has a face with a point that is not there");
      out.push_back(corner.value());
    }
  return std::string(reinterpret_cast<const char*>(out.data()), out.size() * sizeof(std::uint32_t));
}

}  // namespace

void decodeDraco(Json& json, Json& primitive, const std::string& where, Document& document) {
  const Json extension = primitive["extensions"]["KHR_draco_mesh_compression"];
  const std::string place = where + ".extensions.KHR_draco_mesh_compression";
  const auto viewIndex = extension["bufferView"].get<std::size_t>();
  document.demand(at("bufferViews", viewIndex));
  const Json& view = json["bufferViews"][viewIndex];
  const auto mesh = decode(bytesWithin(document.buffers[view["buffer"].get<std::size_t>()],
                                       view.value("byteOffset", std::uint64_t(0)), view["byteLength"],
                                       at("bufferViews", viewIndex)),
                           place);
  for (const auto& [name, id] : extension["attributes"].items()) {
    const auto described = primitive["attributes"].find(name);
    if (described == primitive["attributes"].end()) continue;
    *described = plainAccessor(json, document, *mesh, id, described->get<std::size_t>(),
                               place + ".attributes." + name);
  }
  const std::size_t count = std::size_t(mesh->num_faces()) * 3;
  primitive["indices"] =
      addAccessor(json, {{"bufferView", addView(json, document, bytesOfFaces(*mesh, place))},
                         {"componentType", TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT},
                         {"count", count},
                         {"type", "SCALAR"}});
  primitive["mode"] = TINYGLTF_MODE_TRIANGLES;
}

}  // namespace gltf
