// SPDX-License-Identifier: MIT
// Model -> one mesh and one object for each group and material.
#include <cmath>

#include "materials.hpp"
#include "model.hpp"

namespace obj {

namespace sdk = steradian::sdk;

namespace {

/// Gives each distinct corner of one part a vertex.
class Vertices {
 public:
  explicit Vertices(const Model& model) : first_(model.positions.size(), kNone) {}

  std::uint32_t of(const Corner& corner) {
    std::uint32_t& first = first_[std::size_t(corner.position)];
    if (first == kNone) touched_.push_back(std::size_t(corner.position));
    std::uint32_t each = first;
    for (int tries = 0; each != kNone && tries < kMostTries; ++tries, each = next_[each])
      if (corners_[each].uv == corner.uv && corners_[each].normal == corner.normal) return each;
    const auto vertex = std::uint32_t(corners_.size());
    corners_.push_back(corner);
    next_.push_back(first);
    return first = vertex;
  }
  const std::vector<Corner>& corners() const { return corners_; }
  void clear() {
    for (const std::size_t position : touched_) first_[position] = kNone;
    touched_.clear(), corners_.clear(), next_.clear();
  }

 private:
  static constexpr std::uint32_t kNone = ~0u;
  static constexpr int kMostTries = 32;  // a position with more corners than that has some vertices twice
  std::vector<std::uint32_t> first_;     // newest vertex of each position; older ones follow through next_
  std::vector<std::uint32_t> next_;
  std::vector<Corner> corners_;
  std::vector<std::size_t> touched_;
};

/// The arrays of one mesh record.
struct Arrays {
  std::vector<Vec3> positions, normals;
  std::vector<std::array<float, 2>> uvs;
  std::vector<std::array<float, 4>> colors;
  std::vector<std::uint32_t> triangles;

  sdk::MeshRecord record() const {
    sdk::MeshRecord out{.vertexCount = positions.size(), .triangleCount = triangles.size() / 3};
    out.positions = positions.empty() ? nullptr : positions[0].data();
    out.triangles = triangles.data();
    if (!normals.empty()) out.normals = normals[0].data();
    if (!uvs.empty()) out.uv0 = uvs[0].data();
    if (!colors.empty()) out.colors = colors[0].data();
    return out;
  }
};

bool normalize(Vec3& v) {
  const double length = std::sqrt(double(v[0]) * v[0] + double(v[1]) * v[1] + double(v[2]) * v[2]);
  if (!(length > 1e-30)) return false;
  for (float& each : v) each = float(each / length);
  return true;
}

class Builder {
 public:
  explicit Builder(Model& model) : model_(model), vertices_(model) {}

  Arrays arraysOf(const Part& part) {
    vertices_.clear();
    Arrays out;
    bool uvs = false, normals = false;
    for (const Face& face : part.faces)
      for (std::size_t i = face.first; i < face.first + face.count; ++i)
        uvs = uvs || model_.corners[i].uv >= 0, normals = normals || model_.corners[i].normal >= 0;
    for (const Face& face : part.faces) addFace(face, normals, out.triangles);
    for (const Corner& c : vertices_.corners()) {
      out.positions.push_back(model_.positions[std::size_t(c.position)]);
      if (uvs) out.uvs.push_back(c.uv < 0 ? std::array<float, 2>{} : model_.uvs[std::size_t(c.uv)]);
      if (normals) out.normals.push_back(model_.normals[std::size_t(c.normal)]);
      if (model_.colors.empty()) continue;
      const Vec3& color = model_.colors[std::size_t(c.position)];
      out.colors.push_back({color[0], color[1], color[2], 1});
    }
    return out;
  }
  std::size_t fans() const { return fans_; }  // polygons too large to be cut with care

 private:
  void addFace(const Face& face, bool normals, std::vector<std::uint32_t>& triangles) {
    Corner* corners = &model_.corners[face.first];
    points_.clear();
    for (std::size_t i = 0; i < face.count; ++i)
      points_.push_back(model_.positions[std::size_t(corners[i].position)]);
    if (normals) completeNormals(corners, face.count);
    fans_ += face.count > sdk::Triangulator::kMostClipped;
    for (const std::uint32_t i : triangulate_(points_)) triangles.push_back(vertices_.of(corners[i]));
  }

  /// Corners without a normal of their own get the face's.
  void completeNormals(Corner* corners, std::size_t count) {
    std::int32_t ofFace = -1;
    for (std::size_t i = 0; i < count; ++i) {
      if (corners[i].normal >= 0 && normalize(model_.normals[std::size_t(corners[i].normal)])) continue;
      if (ofFace < 0) {
        const auto n = sdk::Triangulator::normal(points_);
        const double length = std::hypot(n[0], n[1], n[2]);
        ofFace = std::int32_t(model_.normals.size());
        model_.normals.push_back({0, 1, 0});
        for (std::size_t k = 0; k < 3 && length > 0; ++k) model_.normals.back()[k] = float(n[k] / length);
      }
      corners[i].normal = ofFace;
    }
  }

  Model& model_;
  Vertices vertices_;
  sdk::Triangulator triangulate_;
  std::vector<Vec3> points_;
  std::size_t fans_ = 0;
};

void reportLeftOut(sdk::Host& host, const Model& model, std::size_t fans) {
  for (const auto& [statement, count] : model.leftOut)
    host.notKept(statement, "left out: " + std::to_string(count) + " of them, which are not rendered");
  if (model.smoothingGroups && model.normals.empty())
    host.notKept("smoothing groups", "approximated: without normals (vn) the faces are flat");
  if (fans)
    host.notKept("polygons of more than 512 corners",
                 "approximated: " + std::to_string(fans) + " of them were cut as if they were convex");
}

}  // namespace

void build(sdk::Host& host, Model& model, const std::string& name, sdk::SceneSink& sink) {
  if (model.parts.empty()) throw sdk::BadInput("has no faces; points and lines are not rendered");
  Materials materials(host, sink);
  for (const std::string& library : model.libraries) materials.read(library);
  for (const Part& part : model.parts) materials.id(part.material);
  Builder builder(model);
  std::uint32_t mesh = 0;
  for (const Part& part : model.parts) {
    if (host.cancelled()) throw sdk::Cancelled{};
    const std::string called = utf8Of(!part.name.empty()       ? part.name
                                      : !part.material.empty() ? part.material
                                                               : name);
    const Arrays arrays = builder.arraysOf(part);
    sdk::MeshRecord record = arrays.record();
    record.id = ++mesh, record.name = called;
    sink.addMesh(record);
    sdk::ObjectRecord object{.id = materials.count() + mesh, .kind = sdk::ObjectKind::mesh};
    object.name = called, object.mesh = mesh, object.material = materials.id(part.material);
    sink.addObject(object);
    host.progress(0.7 + 0.3 * mesh / double(model.parts.size()));
  }
  reportLeftOut(host, model, builder.fans());
}

}  // namespace obj
