// SPDX-License-Identifier: MIT
#include "tests/oracle/intersect.hpp"

#include <cmath>
#include <limits>

namespace steradian::oracle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The part of a line that lies in a convex solid; empty when t1 <= t0.
struct Span {
  double t0 = -kInfinity, t1 = kInfinity;
  dvec3 n0{0.0}, n1{0.0};  // outward, at either end
};

void clipToSlab(Span& span, const Ray& ray, int axis, double half) {
  const double o = ray.origin[axis], d = ray.direction[axis];
  if (d == 0.0) {
    if (std::abs(o) > half) span.t1 = -kInfinity;
    return;
  }
  dvec3 outward(0.0);
  outward[axis] = d > 0.0 ? 1.0 : -1.0;
  const double enter = (-half * outward[axis] - o) / d, leave = (half * outward[axis] - o) / d;
  if (enter > span.t0) span.t0 = enter, span.n0 = -outward;
  if (leave < span.t1) span.t1 = leave, span.n1 = outward;
}

/// Clips to |origin + t direction| <= radius, both taken without their components where mask is 0: the
/// closest approach to the centre, and half a chord to either side of it.
void clipToRound(Span& span, const Ray& ray, const dvec3& mask, double radius) {
  const dvec3 o = ray.origin * mask, d = ray.direction * mask;
  const double length = glm::length(d);
  if (length == 0.0) {
    if (glm::length(o) > radius) span.t1 = -kInfinity;
    return;
  }
  const dvec3 unit = d / length;
  const double along = -glm::dot(o, unit);
  const dvec3 closest = o + along * unit;
  const double halfSquared = radius * radius - glm::dot(closest, closest);
  if (halfSquared <= 0.0) {
    span.t1 = -kInfinity;
    return;
  }
  const double half = std::sqrt(halfSquared);
  const double enter = (along - half) / length, leave = (along + half) / length;
  if (enter > span.t0) span.t0 = enter, span.n0 = o + enter * d;
  if (leave < span.t1) span.t1 = leave, span.n1 = o + leave * d;
}

std::optional<Hit> firstEnd(const Span& span, double tMin) {
  if (!(span.t0 < span.t1)) return {};
  if (span.t0 > tMin) return Hit{.t = span.t0, .normal = span.n0};
  if (span.t1 > tMin) return Hit{.t = span.t1, .normal = span.n1};
  return {};
}

std::optional<Hit> meetGround(const Ray& ray, double tMin) {
  const double t = -ray.origin.y / ray.direction.y;
  if (!(t > tMin) || t == kInfinity) return {};
  return Hit{.t = t, .normal = {0.0, 1.0, 0.0}};
}

/// Moller and Trumbore 1997: t and the two barycentrics as ratios of determinants.
std::optional<Hit> meetTriangle(const Ray& ray, double tMin, const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
  const double det = glm::dot(ab, p);
  if (det == 0.0) return {};
  const dvec3 toOrigin = ray.origin - a, q = glm::cross(toOrigin, ab);
  const double u = glm::dot(toOrigin, p) / det, v = glm::dot(ray.direction, q) / det,
               t = glm::dot(ac, q) / det;
  if (u < 0.0 || v < 0.0 || u + v > 1.0 || !(t > tMin)) return {};
  return Hit{t, glm::cross(ab, ac), nullptr, 0, {u, v}};
}

struct Meet {
  const Ray& ray;
  double tMin;

  std::optional<Hit> operator()(const Sphere& s) const {
    Span span;
    clipToRound(span, ray, dvec3(1.0), s.radius);
    return firstEnd(span, tMin);
  }
  std::optional<Hit> operator()(const Box& b) const {
    Span span;
    for (int axis = 0; axis < 3; ++axis) clipToSlab(span, ray, axis, 0.5 * b.size[axis]);
    return firstEnd(span, tMin);
  }
  std::optional<Hit> operator()(const Cylinder& c) const {
    Span span;
    clipToRound(span, ray, {1.0, 0.0, 1.0}, c.radius);
    clipToSlab(span, ray, 1, 0.5 * c.height);
    return firstEnd(span, tMin);
  }
  std::optional<Hit> operator()(const Plane&) const { return meetGround(ray, tMin); }
  std::optional<Hit> operator()(const Rect& r) const {
    const auto hit = meetGround(ray, tMin);
    if (!hit) return {};
    const dvec3 p = ray.at(hit->t);
    if (std::abs(p.x) > 0.5 * r.size.x || std::abs(p.z) > 0.5 * r.size.y) return {};
    return hit;
  }
  std::optional<Hit> operator()(const Disk& d) const {
    const auto hit = meetGround(ray, tMin);
    if (!hit) return {};
    const dvec3 p = ray.at(hit->t);
    if (p.x * p.x + p.z * p.z > d.radius * d.radius) return {};
    return hit;
  }
  std::optional<Hit> operator()(const MeshShape& s) const {
    std::optional<Hit> nearest;
    const auto& at = s.mesh->positions;
    for (std::size_t i = 0; i < s.mesh->triangles.size(); ++i) {
      const glm::uvec3& t = s.mesh->triangles[i];
      const auto hit = meetTriangle(ray, tMin, dvec3(at[t.x]), dvec3(at[t.y]), dvec3(at[t.z]));
      if (!hit || (nearest && hit->t >= nearest->t)) continue;
      nearest = hit;
      nearest->triangle = i;
    }
    return nearest;
  }
};

}  // namespace

std::optional<Hit> intersect(const Shape& shape, const Ray& ray, double tMin) {
  return std::visit(Meet{ray, tMin}, shape);
}

std::optional<Hit> intersect(const Body& body, const Ray& ray, double tMin) {
  const dmat4& m = body.objectFromWorld;
  // An affine map keeps the parameter, as the direction is not normalized.
  const Ray local{dvec3(m * glm::dvec4(ray.origin, 1.0)), dmat3(m) * ray.direction};
  auto hit = intersect(body.shape, local, tMin);
  if (!hit) return {};
  hit->normal = glm::normalize(glm::transpose(dmat3(m)) * hit->normal);
  hit->body = &body;
  return hit;
}

std::optional<Hit> nearest(const World& world, const Ray& ray, double tMin) {
  std::optional<Hit> best;
  for (const Body& body : world.bodies) {
    const auto hit = intersect(body, ray, tMin);
    if (hit && (!best || hit->t < best->t)) best = hit;
  }
  return best;
}

double selfDistance(const dvec3& origin) {
  return 1e-9 * (1.0 + glm::length(origin));
}

}  // namespace steradian::oracle
