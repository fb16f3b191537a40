// SPDX-License-Identifier: MIT
// The attributes of a primitive.
#include "mesh.hpp"

#include <algorithm>
#include <cmath>

#include "views.hpp"

namespace gltf {

namespace {

class Attributes {
 public:
  Attributes(const Document& document, const tinygltf::Primitive& primitive, const std::string& place)
      : document_(document), primitive_(primitive), place_(place) {}

  std::vector<glm::vec3> positions() {
    const int accessor = find("POSITION");
    if (accessor < 0) throw sdk::BadInput(place_ + ".attributes: expected POSITION");
    const Numbers numbers = readNumbers(document_, accessor, {"POSITION", 3, 3});
    demandFinite(numbers, accessor, "POSITION");
    count_ = numbers.count();
    if (count_ == 0) throw sdk::BadInput(place_ + ": has no vertices");
    return vectorsOf<glm::vec3>(numbers);
  }
  template <class Vector>
  std::vector<Vector> read(const char* name, bool finite = true) {
    const int accessor = find(name);
    if (accessor < 0) return {};
    const Numbers numbers =
        readNumbers(document_, accessor, {name, Vector::length(), Vector::length(), count_});
    if (finite) demandFinite(numbers, accessor, name);
    return vectorsOf<Vector>(numbers);
  }
  /// RGB or RGBA, in [0, 1].
  std::vector<glm::vec4> colors() {
    const int accessor = find("COLOR_0");
    if (accessor < 0) return {};
    const Numbers numbers = readNumbers(document_, accessor, {"COLOR_0", 3, 4, count_});
    demandFinite(numbers, accessor, "COLOR_0");
    std::vector<glm::vec4> out(count_, glm::vec4(1.0f));
    for (std::size_t i = 0; i < numbers.values.size(); ++i)
      out[i / std::size_t(numbers.components)][int(i % std::size_t(numbers.components))] =
          std::clamp(numbers.values[i], 0.0f, 1.0f);
    return out;
  }
  int find(const char* name) const {
    const auto found = primitive_.attributes.find(name);
    return found == primitive_.attributes.end() ? -1 : found->second;
  }

 private:
  const Document& document_;
  const tinygltf::Primitive& primitive_;
  const std::string& place_;
  std::size_t count_ = 0;
};

void noteUnread(const tinygltf::Primitive& primitive, std::vector<std::string>& notes) {
  static constexpr std::string_view kRead[] = {"POSITION",   "NORMAL",     "TANGENT",
                                               "TEXCOORD_0", "TEXCOORD_1", "COLOR_0"};
  for (const auto& [name, accessor] : primitive.attributes)
    if (std::find(std::begin(kRead), std::end(kRead), name) == std::end(kRead) &&
        name.rfind("JOINTS_", 0) != 0 && name.rfind("WEIGHTS_", 0) != 0)
      notes.push_back("attribute " + name + " is left out");
}

glm::vec3 facetNormal(const Triangles& t, std::size_t triangle) {
  const auto corner = [&](std::size_t i) { return glm::dvec3(t.positions[t.indices[triangle * 3 + i]]); };
  const glm::dvec3 n = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
  const double length = glm::length(n);
  return length > 0 && std::isfinite(length) ? glm::vec3(n / length) : glm::vec3(0, 1, 0);
}

/// Normals that point nowhere take a facet's; the others keep their direction.
void makeUnit(Triangles& t) {
  std::vector<bool> broken(t.normals.size(), false);
  std::size_t count = 0;
  for (std::size_t i = 0; i < t.normals.size(); ++i) {
    const float length = glm::length(t.normals[i]);
    broken[i] = !(length > 1e-6f && length < 1e12f);
    if (broken[i])
      t.normals[i] = {0, 1, 0}, ++count;
    else
      t.normals[i] /= length;
  }
  if (count == 0) return;
  t.notes.push_back(std::to_string(count) + " normals without a direction take that of a facet");
  for (std::size_t i = 0; i < t.indices.size(); ++i)
    if (broken[t.indices[i]]) t.normals[t.indices[i]] = facetNormal(t, i / 3), broken[t.indices[i]] = false;
}

void makeTangentsUnit(Triangles& t) {
  for (glm::vec4& tangent : t.tangents) {
    const float length = glm::length(glm::vec3(tangent));
    if (!(length > 1e-6f && length < 1e12f) || !std::isfinite(tangent.w)) {
      t.notes.push_back("its tangents, some without a direction, are left out");
      t.tangents.clear();
      return;
    }
    tangent = glm::vec4(glm::vec3(tangent) / length, tangent.w < 0 ? -1.0f : 1.0f);
  }
}

}  // namespace

Triangles readPrimitive(const Document& document, const tinygltf::Primitive& primitive,
                        const std::string& place, const Bend& bend) {
  document.demand(place);
  Attributes attributes(document, primitive, place);
  Triangles out;
  out.positions = attributes.positions();
  out.indices = readTriangles(document, primitive, out.positions.size(), out.notes);
  if (out.indices.empty()) throw sdk::BadInput(place + ": has no triangles");
  out.normals = attributes.read<glm::vec3>("NORMAL", false);
  // glTF 2.0, 3.7.2.1: without normals the facets are flat, and tangents are ignored.
  if (!out.normals.empty()) out.tangents = attributes.read<glm::vec4>("TANGENT", false);
  out.uv0 = attributes.read<glm::vec2>("TEXCOORD_0");
  out.uv1 = attributes.read<glm::vec2>("TEXCOORD_1");
  out.colors = attributes.colors();
  noteUnread(primitive, out.notes);
  morph(document, primitive, place, bend.weights, out);
  skin(document, primitive, bend.joints, out);
  for (const glm::vec3& p : out.positions)
    if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 1e12f))
      throw sdk::BadInput(place + ": its skin or morph targets move a vertex beyond 1e12");
  makeUnit(out);
  makeTangentsUnit(out);
  return out;
}

}  // namespace gltf
