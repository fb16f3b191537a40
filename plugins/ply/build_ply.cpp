// SPDX-License-Identifier: MIT
// Vertices and faces -> one mesh.
#include "build_ply.hpp"

#include <algorithm>
#include <cmath>

namespace ply {

namespace sdk = steradian::sdk;

namespace {

/// IEC 61966-2-1: whole-number colours are meant for the screen.
double linearFromSrgb(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double largestOf(Type type) {
  return std::ldexp(1.0, int(8 * sizeOf(type)) -
                             (type == Type::int8 || type == Type::int16 || type == Type::int32)) -
         1;
}

float colorOf(double value, Type type, bool alpha) {
  const double unit = std::clamp(isFloat(type) ? value : value / largestOf(type), 0.0, 1.0);
  return float(isFloat(type) || alpha ? unit : linearFromSrgb(unit));
}

enum class Role { none, position, normal, uv, color };
struct Target {
  Role role = Role::none;
  std::size_t component = 0;
};

Target targetOf(std::string_view name) {
  static constexpr struct {
    const char* name;
    Role role;
    std::size_t component;
  } kNames[] = {{"x", Role::position, 0},
                {"y", Role::position, 1},
                {"z", Role::position, 2},
                {"nx", Role::normal, 0},
                {"ny", Role::normal, 1},
                {"nz", Role::normal, 2},
                {"s", Role::uv, 0},
                {"t", Role::uv, 1},
                {"u", Role::uv, 0},
                {"v", Role::uv, 1},
                {"texture_u", Role::uv, 0},
                {"texture_v", Role::uv, 1},
                {"red", Role::color, 0},
                {"green", Role::color, 1},
                {"blue", Role::color, 2},
                {"alpha", Role::color, 3},
                {"r", Role::color, 0},
                {"g", Role::color, 1},
                {"b", Role::color, 2},
                {"diffuse_red", Role::color, 0},
                {"diffuse_green", Role::color, 1},
                {"diffuse_blue", Role::color, 2}};
  for (const auto& each : kNames)
    if (name == each.name) return {each.role, each.component};
  return {};
}

}  // namespace

void Builder::read(const Header& header, Values& values) {
  for (const Element& element : header.elements) {
    if (element.name == "vertex")
      vertices(element, values);
    else if (element.name == "face")
      faces(element, values);
    else
      skip(element, values);
  }
  if (triangles_.empty()) throw sdk::BadInput("has no faces; points and lines are not rendered");
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    if (triangles_[i] >= positions_.size())
      throw sdk::BadInput("a face names vertex " + std::to_string(triangles_[i]) + "; there are " +
                          std::to_string(positions_.size()));
  completeNormals();
}

void Builder::everyRow(const Element& element, Values& values, std::uint64_t row) {
  values.enter(element, row);
  if (row % 65536 != 0) return;
  if (host_.cancelled()) throw sdk::Cancelled{};
  host_.progress(values.progress());
}

void Builder::skip(const Element& element, Values& values) {
  if (element.count > 0)
    host_.notKept(element.name,
                  "left out: " + std::to_string(element.count) + " of them, which are not rendered");
  for (std::uint64_t row = 0; row < element.count && !element.properties.empty(); ++row) {
    everyRow(element, values, row);
    for (const Property& property : element.properties) values.skip(property);
  }
}

void Builder::vertices(const Element& element, Values& values) {
  if (!positions_.empty()) throw sdk::BadInput("has two lists of vertices");
  std::vector<Target> targets;
  unsigned found[5] = {};
  for (const Property& p : element.properties) {
    targets.push_back(p.list ? Target{} : targetOf(p.name));
    found[std::size_t(targets.back().role)] |= 1u << targets.back().component;
    if (targets.back().role == Role::none) host_.notKept("vertex " + p.name, "left out: is not rendered");
  }
  if (found[std::size_t(Role::position)] != 7) throw sdk::BadInput("its vertices lack x, y or z");
  positions_.assign(element.count, {0, 0, 0});
  if (found[std::size_t(Role::normal)] == 7) normals_.assign(element.count, {0, 0, 0});
  if (found[std::size_t(Role::uv)] == 3) uvs_.assign(element.count, {0, 0});
  if ((found[std::size_t(Role::color)] & 7) == 7) colors_.assign(element.count, {1, 1, 1, 1});
  for (std::uint64_t row = 0; row < element.count; ++row) {
    everyRow(element, values, row);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const Property& p = element.properties[i];
      if (targets[i].role == Role::none)
        values.skip(p);
      else
        put(row, int(targets[i].role), targets[i].component, p.type, values);
    }
  }
}

void Builder::put(std::uint64_t row, int role, std::size_t component, Type type, Values& values) {
  const double value = values.next(type);
  if (!(std::abs(value) <= 1e12)) values.fail("holds a value that is not a number or beyond 1e12");
  if (Role(role) == Role::position) positions_[row][component] = float(value);
  if (Role(role) == Role::normal && !normals_.empty()) normals_[row][component] = float(value);
  if (Role(role) == Role::uv && !uvs_.empty()) uvs_[row][component] = float(component ? 1 - value : value);
  if (Role(role) == Role::color && !colors_.empty())
    colors_[row][component] = colorOf(value, type, component == 3);
}

void Builder::faces(const Element& element, Values& values) {
  const auto isIndices = [](const Property& p) {
    return p.list && !isFloat(p.type) && (p.name == "vertex_indices" || p.name == "vertex_index");
  };
  for (const Property& p : element.properties)
    if (!isIndices(p)) host_.notKept("face " + p.name, "left out: is not rendered");
  for (std::uint64_t row = 0; row < element.count; ++row) {
    everyRow(element, values, row);
    for (const Property& p : element.properties) isIndices(p) ? face(p, values) : values.skip(p);
  }
  if (tooSmall_)
    host_.notKept("faces of fewer than 3 corners", "left out: " + std::to_string(tooSmall_) + " of them");
}

void Builder::face(const Property& list, Values& values) {
  const std::uint64_t count = values.length(list);
  corners_.clear(), points_.clear();
  for (std::uint64_t i = 0; i < count; ++i) {
    const double index = values.next(list.type);
    // Faces may stand before the vertices; then the end of the file checks them.
    if (!(index >= 0 && index < 2147483647.0) || index != std::floor(index) ||
        (!positions_.empty() && index >= double(positions_.size())))
      values.fail("names vertex " + std::to_string(std::int64_t(std::clamp(index, -1e15, 1e15))) +
                  "; there are " + std::to_string(positions_.size()));
    corners_.push_back(std::uint32_t(index));
    points_.push_back(positions_.empty() ? sdk::Triangulator::Point{} : positions_[corners_.back()]);
  }
  tooSmall_ += count < 3;
  for (const std::uint32_t corner : triangulate_(points_)) triangles_.push_back(corners_[corner]);
}

/// Unit length; a vertex whose normal has none gets the sum of its triangles'.
void Builder::completeNormals() {
  const auto unit = [](Vec3& n) {
    const double length = std::hypot(double(n[0]), double(n[1]), double(n[2]));
    for (float& each : n) each = length > 1e-30 ? float(each / length) : 0.0f;
    return length > 1e-30;
  };
  std::vector<bool> missing(normals_.size());
  bool any = false;
  for (std::size_t i = 0; i < normals_.size(); ++i) any |= missing[i] = !unit(normals_[i]);
  if (!any) return;
  for (std::size_t i = 0; i + 2 < triangles_.size(); i += 3) {
    const Vec3 corners[] = {positions_[triangles_[i]], positions_[triangles_[i + 1]],
                            positions_[triangles_[i + 2]]};
    auto n = sdk::Triangulator::normal(corners);
    for (std::size_t c = 0; c < 3; ++c)
      if (missing[triangles_[i + c]])
        for (std::size_t k = 0; k < 3; ++k) normals_[triangles_[i + c]][k] += float(n[k]);
  }
  for (std::size_t i = 0; i < normals_.size(); ++i)
    if (missing[i] && !unit(normals_[i])) normals_[i] = {0, 1, 0};
}

void Builder::push(sdk::SceneSink& sink) const {
  sdk::MeshRecord mesh{
      .id = 1, .name = "Mesh", .vertexCount = positions_.size(), .triangleCount = triangles_.size() / 3};
  mesh.positions = positions_[0].data();
  mesh.triangles = triangles_.data();
  if (!normals_.empty()) mesh.normals = normals_[0].data();
  if (!uvs_.empty()) mesh.uv0 = uvs_[0].data();
  if (!colors_.empty()) mesh.colors = colors_[0].data();
  sink.addMesh(mesh);
  sdk::ObjectRecord object{.id = 1, .kind = sdk::ObjectKind::mesh};
  object.name = "Mesh", object.mesh = 1;
  sink.addObject(object);
}

}  // namespace ply
