// SPDX-License-Identifier: MIT
#include "renderer/gpu_shapes.hpp"

#include <cmath>
#include <limits>

#include "renderer/rows.hpp"

namespace steradian {
namespace {

void push(ShapeList& list, std::initializer_list<glm::vec4> rows, SurfaceLink link, const Placement& place) {
  list.rows.insert(list.rows.end(), rows);
  list.links.push_back(link);
  list.places.push_back(place);
}

// Rows of the 3x3 that maps a camera-relative world offset to the unit shape, with the centre beside it.
void pushAffine(ShapeList& list, const glm::dmat3& worldFromUnit, const glm::dvec3& centre,
                SurfaceLink link) {
  const double determinant = glm::determinant(worldFromUnit);
  if (!std::isfinite(determinant) || determinant == 0.0) return;
  const glm::dmat3 byRow = glm::transpose(glm::inverse(worldFromUnit));
  push(list, {row(byRow[0], centre.x), row(byRow[1], centre.y), row(byRow[2], centre.z)}, link,
       {worldFromUnit, centre});
}

glm::dmat3 scaled(const glm::dmat3& m, const glm::dvec3& size) {
  return glm::dmat3(m[0] * size.x, m[1] * size.y, m[2] * size.z);
}

void pushSphere(ShapeLists& lists, double radius, const glm::dvec3& centre, SurfaceLink link,
                double largeRadius) {
  if (!(radius > 0.0)) return;
  const glm::vec4 high = row(centre, radius);
  const Placement place{glm::dmat3(radius), centre};
  if (radius < largeRadius) return push(lists.kinds[spheres], {high}, link, place);
  // What float rounded away, so that shaders see the centre and radius as double-floats.
  push(lists.kinds[largeSpheres], {high, row(centre - glm::dvec3(high), radius - double(high.w))}, link,
       place);
}

// A wall that was turned by a right angle faces an axis: what the digits of its rotation leave of the others
// is 0.
glm::dvec3 withoutDust(glm::dvec3 unit) {
  constexpr double dust = 4.0 * std::numeric_limits<double>::epsilon();
  for (int c = 0; c < 3; ++c)
    if (std::abs(unit[c]) < dust) unit[c] = 0.0;
  return unit;
}

void pushPlane(ShapeLists& lists, const glm::dmat3& m, const glm::dvec3& point, SurfaceLink link) {
  const glm::dvec3 up = glm::cross(m[2], m[0]) * (glm::determinant(m) < 0.0 ? -1.0 : 1.0);
  const double length = glm::length(up);
  if (!std::isfinite(length) || length == 0.0) return;
  const glm::vec3 n(withoutDust(up / length));  // D for the normal as it is stored
  push(lists.kinds[planes], {row(glm::dvec3(n), glm::dot(point, glm::dvec3(n)))}, link, {m, point});
}

}  // namespace

void ShapeLists::add(const Shape& shape, const glm::dmat4& worldFromObject, const glm::dvec3& origin,
                     SurfaceLink link, double largeRadius) {
  const glm::dmat3 m(worldFromObject);
  const glm::dvec3 centre = glm::dvec3(worldFromObject[3]) - origin;
  if (const auto* s = std::get_if<Sphere>(&shape)) {
    if (const auto radius = sphereRadius(*s, worldFromObject)) {
      pushSphere(*this, *radius, centre, link, largeRadius);
    } else {
      pushAffine(kinds[ellipsoids], scaled(m, glm::dvec3(s->radius)), centre, link);
    }
  } else if (std::holds_alternative<Plane>(shape)) {
    pushPlane(*this, m, centre, link);
  } else if (const auto* b = std::get_if<Box>(&shape)) {
    pushAffine(kinds[boxes], scaled(m, b->size * 0.5), centre, link);
  } else if (const auto* r = std::get_if<Rect>(&shape)) {
    pushAffine(kinds[rects], scaled(m, {r->size.x * 0.5, 1.0, r->size.y * 0.5}), centre, link);
  } else if (const auto* d = std::get_if<Disk>(&shape)) {
    pushAffine(kinds[disks], scaled(m, {d->radius, 1.0, d->radius}), centre, link);
  } else if (const auto* c = std::get_if<Cylinder>(&shape)) {
    pushAffine(kinds[cylinders], scaled(m, {c->radius, c->height * 0.5, c->radius}), centre, link);
  }
}

void ShapeLists::addLight(const Light& light, const glm::dmat4& worldFromObject, const glm::dvec3& origin,
                          Id object, double largeRadius) {
  const SurfaceLink link{Id::none, object, &light};
  // Flat lights shine along -Z, flat shapes face +Y: turn the one into the other, keeping X.
  const glm::dmat4& w = worldFromObject;
  const glm::dmat4 facing(w[0], -w[2], w[1], w[3]);
  if (const auto* s = std::get_if<SphereLight>(&light.kind))
    add(Sphere{s->radius}, worldFromObject, origin, link, largeRadius);
  else if (const auto* r = std::get_if<RectLight>(&light.kind))
    add(Rect{r->size}, facing, origin, link, largeRadius);
  else if (const auto* d = std::get_if<DiskLight>(&light.kind))
    add(Disk{d->radius}, facing, origin, link, largeRadius);
}

std::optional<double> sphereRadius(const Sphere& sphere, const glm::dmat4& worldFromObject) {
  const glm::dmat3 m(worldFromObject);
  const glm::dmat3 gram = glm::transpose(m) * m;
  const double s2 = gram[0][0];
  const double off = std::max({std::abs(gram[0][1]), std::abs(gram[0][2]), std::abs(gram[1][2])});
  const double uneven = std::max(std::abs(gram[1][1] - s2), std::abs(gram[2][2] - s2));
  if (std::max(off, uneven) > 1e-9 * s2) return std::nullopt;
  return sphere.radius * std::sqrt(s2);
}

double smallestExtent(const Shape& shape, const glm::dmat4& worldFromObject) {
  const glm::dmat3 m(worldFromObject);
  const double scale = std::min({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
  struct Extent {
    double operator()(const Sphere& s) const { return s.radius; }
    double operator()(const Plane&) const { return std::numeric_limits<double>::infinity(); }
    double operator()(const Box& b) const { return std::min({b.size.x, b.size.y, b.size.z}); }
    double operator()(const Rect& r) const { return std::min(r.size.x, r.size.y); }
    double operator()(const Disk& d) const { return d.radius; }
    double operator()(const Cylinder& c) const { return std::min(c.radius, c.height); }
    double operator()(const MeshShape&) const { return std::numeric_limits<double>::infinity(); }
  };
  return scale * std::visit(Extent{}, shape);
}

}  // namespace steradian
