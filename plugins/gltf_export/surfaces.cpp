// SPDX-License-Identifier: MIT
// Triangles for what glTF has no word for: analytic shapes and the bodies of area lights.
#include "surfaces.hpp"

#include <array>
#include <cmath>

namespace gltf_export {

namespace {

namespace sdk = steradian::sdk;
using Vec = std::array<double, 3>;

constexpr int kTurn = 64;  // steps around: the sagitta is 1 - cos(pi/64) = 0.12 % of the radius
constexpr double kPi = 3.14159265358979323846, kPlaneHalf = 1000.0;

Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec normalized(const Vec& v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

std::uint32_t vertex(Triangles& out, const Vec& p, const Vec& n) {
  for (const double x : p) out.positions.push_back(float(x));
  for (const double x : n) out.normals.push_back(float(x));
  return std::uint32_t(out.positions.size() / 3 - 1);
}

void triangle(Triangles& out, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  out.indices.insert(out.indices.end(), {a, b, c});
}

/// A parallelogram centre +-u +-v that faces cross(u, v).
void quad(Triangles& out, const Vec& centre, const Vec& u, const Vec& v) {
  const Vec n = normalized(cross(u, v));
  std::uint32_t corner[4];
  for (int i = 0; i < 4; ++i) {
    const double s = i == 0 || i == 3 ? -1.0 : 1.0, t = i < 2 ? -1.0 : 1.0;
    corner[i] = vertex(
        out,
        {centre[0] + s * u[0] + t * v[0], centre[1] + s * u[1] + t * v[1], centre[2] + s * u[2] + t * v[2]},
        n);
  }
  triangle(out, corner[0], corner[1], corner[2]);
  triangle(out, corner[0], corner[2], corner[3]);
}

/// A disk of semi-axes u and v that faces cross(u, v).
void disk(Triangles& out, const Vec& centre, const Vec& u, const Vec& v) {
  const Vec n = normalized(cross(u, v));
  const std::uint32_t middle = vertex(out, centre, n);
  for (int i = 0; i < kTurn; ++i) {
    const double c = std::cos(2 * kPi * i / kTurn), s = std::sin(2 * kPi * i / kTurn);
    vertex(
        out,
        {centre[0] + c * u[0] + s * v[0], centre[1] + c * u[1] + s * v[1], centre[2] + c * u[2] + s * v[2]},
        n);
  }
  for (int i = 0; i < kTurn; ++i)
    triangle(out, middle, middle + 1 + std::uint32_t(i), middle + 1 + std::uint32_t((i + 1) % kTurn));
}

/// Rows of a surface of revolution around Y, from +Y to -Y: (radius, height) and the normal's (radial, y).
struct Ring {
  double radius, y, normalRadius, normalY;
};

void revolve(Triangles& out, const std::vector<Ring>& rings) {
  const auto first = std::uint32_t(out.positions.size() / 3);
  for (const Ring& ring : rings)
    for (int i = 0; i <= kTurn; ++i) {
      const double c = std::cos(2 * kPi * i / kTurn), s = std::sin(2 * kPi * i / kTurn);
      vertex(out, {ring.radius * c, ring.y, -ring.radius * s},
             {ring.normalRadius * c, ring.normalY, -ring.normalRadius * s});
    }
  for (std::uint32_t row = 0; row + 1 < rings.size(); ++row)
    for (std::uint32_t i = 0; i < kTurn; ++i) {
      const std::uint32_t a = first + row * (kTurn + 1) + i, below = a + kTurn + 1;
      if (rings[row].radius > 0) triangle(out, a, below, a + 1);
      if (rings[row + 1].radius > 0) triangle(out, a + 1, below, below + 1);
    }
}

void sphere(Triangles& out, double radius) {
  std::vector<Ring> rings;
  constexpr int kRows = kTurn / 2;
  for (int i = 0; i <= kRows; ++i) {
    const double s = i == 0 || i == kRows ? 0.0 : std::sin(kPi * i / kRows), c = std::cos(kPi * i / kRows);
    rings.push_back({radius * s, radius * c, s, c});
  }
  revolve(out, rings);
}

void box(Triangles& out, const double (&size)[3]) {
  const double x = size[0] / 2, y = size[1] / 2, z = size[2] / 2;
  quad(out, {x, 0, 0}, {0, y, 0}, {0, 0, z});
  quad(out, {-x, 0, 0}, {0, 0, z}, {0, y, 0});
  quad(out, {0, y, 0}, {0, 0, z}, {x, 0, 0});
  quad(out, {0, -y, 0}, {x, 0, 0}, {0, 0, z});
  quad(out, {0, 0, z}, {x, 0, 0}, {0, y, 0});
  quad(out, {0, 0, -z}, {0, y, 0}, {x, 0, 0});
}

void cylinder(Triangles& out, double radius, double height) {
  revolve(out, {{radius, height / 2, 1, 0}, {radius, -height / 2, 1, 0}});
  disk(out, {0, height / 2, 0}, {0, 0, radius}, {radius, 0, 0});
  disk(out, {0, -height / 2, 0}, {radius, 0, 0}, {0, 0, radius});
}

}  // namespace

std::optional<Triangles> tessellated(const sdk::ObjectRecord& o) {
  Triangles out;
  const double x = o.dimensions[0] / 2, y = o.dimensions[1] / 2;
  switch (o.kind) {
    case sdk::ObjectKind::sphere:
    case sdk::ObjectKind::sphereLight:
      sphere(out, o.radius);
      return out;
    case sdk::ObjectKind::plane:
      quad(out, {}, {0, 0, kPlaneHalf}, {kPlaneHalf, 0, 0});
      return out;
    case sdk::ObjectKind::box:
      box(out, o.dimensions);
      return out;
    case sdk::ObjectKind::rect:
      quad(out, {}, {0, 0, y}, {x, 0, 0});
      return out;
    case sdk::ObjectKind::disk:
      disk(out, {}, {0, 0, o.radius}, {o.radius, 0, 0});
      return out;
    case sdk::ObjectKind::cylinder:
      cylinder(out, o.radius, o.height);
      return out;
    case sdk::ObjectKind::rectLight:  // faces -Z
      quad(out, {}, {0, y, 0}, {x, 0, 0});
      return out;
    case sdk::ObjectKind::diskLight:
      disk(out, {}, {0, o.radius, 0}, {o.radius, 0, 0});
      return out;
    default:
      return std::nullopt;
  }
}

}  // namespace gltf_export
