// SPDX-License-Identifier: MIT
// Builds small glTF files, sound or not, and imports them.
#pragma once
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {

using Json = nlohmann::json;

inline std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

/// One file: `json` may be changed at will before it is written.
struct GltfMaker {
  Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", Json::array()}}}}};
  std::string bytes;  // of buffer 0

  std::size_t append(const char* list, Json element) {
    json[list].push_back(std::move(element));
    return json[list].size() - 1;
  }
  /// A root node of scene 0.
  std::size_t root(Json node) {
    const std::size_t index = append("nodes", std::move(node));
    json["scenes"][0]["nodes"].push_back(index);
    return index;
  }
  template <class Number>
  std::size_t view(const std::vector<Number>& values) {
    while (bytes.size() % 4) bytes += '\0';
    const std::size_t offset = bytes.size();
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number));
    return append("bufferViews",
                  {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(Number)}});
  }
  template <class Number>
  std::size_t accessor(const std::vector<Number>& values, const char* type, bool normalized = false) {
    const std::map<std::string, std::size_t> sizes = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    const int component = std::is_same_v<Number, float>           ? 5126
                          : std::is_same_v<Number, std::int8_t>   ? 5120
                          : std::is_same_v<Number, std::uint8_t>  ? 5121
                          : std::is_same_v<Number, std::int16_t>  ? 5122
                          : std::is_same_v<Number, std::uint16_t> ? 5123
                                                                  : 5125;
    Json out = {{"bufferView", view(values)},
                {"componentType", component},
                {"count", values.size() / sizes.at(type)},
                {"type", type}};
    if (normalized) out["normalized"] = true;
    return append("accessors", std::move(out));
  }
  std::size_t positions(const std::vector<float>& values) { return accessor(values, "VEC3"); }
  /// A mesh of one primitive.
  std::size_t mesh(Json primitive) {
    return append("meshes", {{"primitives", Json::array({std::move(primitive)})}});
  }
  /// A triangle in a root node; returns the primitive to be changed.
  Json& triangle() {
    const std::size_t p = positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    root({{"name", "tri"}, {"mesh", mesh({{"attributes", {{"POSITION", p}}}})}});
    return json["meshes"].back()["primitives"][0];
  }

  std::string text(const char* uri = nullptr) const {
    Json out = json;
    if (!bytes.empty() && !out.contains("buffers"))
      out["buffers"] = {{{"byteLength", bytes.size()},
                         {"uri", uri ? uri : "data:application/octet-stream;base64," + base64(bytes)}}};
    return out.dump(1);
  }
  std::string glb() const {
    Json out = json;
    if (!bytes.empty() && !out.contains("buffers")) out["buffers"] = {{{"byteLength", bytes.size()}}};
    std::string text = out.dump(), binary = bytes;
    while (text.size() % 4) text += ' ';
    while (binary.size() % 4) binary += '\0';
    const auto word = [](std::size_t value) {
      const auto v = std::uint32_t(value);
      return std::string(reinterpret_cast<const char*>(&v), 4);
    };
    std::string body = word(text.size()) + "JSON" + text;
    if (!binary.empty()) body += word(binary.size()) + std::string("BIN\0", 4) + binary;
    return "glTF" + word(2) + word(12 + body.size()) + body;
  }
};

class Gltf : public FolderTest {
 protected:
  ImportResult import(const std::string& text, const Parameters& parameters = {},
                      const char* name = "a.gltf") {
    writeText(folder / name, text);
    return stockPlugins().importScene(folder / name, {}, parameters);
  }
  ImportResult import(const GltfMaker& maker, const Parameters& parameters = {}) {
    return import(maker.text(), parameters);
  }
  /// The reason of a refusal; always an Error(badInput) that begins with the file's name.
  std::string refusal(const std::string& text, const char* name = "a.gltf") {
    const auto [message, code] = faultOf([&] { import(text, {}, name); });
    EXPECT_EQ(code, ExitCode::badInput) << message;
    EXPECT_EQ(message.rfind((folder / name).string() + ": ", 0), 0u) << message;
    return message;
  }
  std::string refusal(const GltfMaker& maker) { return refusal(maker.text()); }
};

inline std::string linesOf(const ImportReport& report) {
  std::string out;
  for (const auto& line : report.notKept) out += line.what + ": " + line.why + "\n";
  return out;
}

inline const Object& named(const Scene& scene, const char* name) {
  const Object* found = findByName(scene, name);
  if (!found) throw std::runtime_error(std::string("no object ") + name);
  return *found;
}
inline const Mesh& meshOf(const Object& object) {
  return *std::get<MeshShape>(std::get<Geometry>(object.content).shape).mesh;
}
inline const Mesh& onlyMesh(const Scene& scene) {
  return meshOf(scene.objects.at(0));
}

}  // namespace steradian::plugins
