// SPDX-License-Identifier: MIT
#include "renderer/gpu_lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/rows.hpp"
#include "renderer/top_level.hpp"

namespace steradian {

using namespace gpu;

namespace {

using Rows = std::vector<glm::vec4>;

void pushSpot(Rows& rows, const SpotLight& spot, const glm::vec3& position, const glm::vec3& intensity,
              const glm::vec3& axis) {
  const double cosOuter = std::cos(double(spot.outerConeAngle));
  const double scale = 1.0 / std::max(1e-3, std::cos(double(spot.innerConeAngle)) - cosOuter);
  rows.insert(rows.end(), {glm::vec4(position, float(LIGHT_SPOT)), glm::vec4(intensity, float(scale)),
                           glm::vec4(axis, float(-cosOuter * scale)), glm::vec4(0.0f)});
}

void pushDirectional(Rows& rows, const DirectionalLight& light, const glm::vec3& axis, const glm::vec3& lux) {
  const double half = std::sin(0.25 * double(light.angularDiameter));
  rows.insert(rows.end(), {glm::vec4(-axis, float(LIGHT_DIRECTIONAL)),
                           glm::vec4(lux, float(2.0 * half * half)), glm::vec4(0.0f), glm::vec4(0.0f)});
}

// Half axes of a flat shape in its XZ plane, ordered so that cross(u, v) is its +Y side, mirrored or not.
struct FlatAxes {
  glm::dvec3 u, v;
};

FlatAxes flatAxes(const glm::dmat3& m) {
  return glm::determinant(m) < 0.0 ? FlatAxes{m[0], m[2]} : FlatAxes{m[2], m[0]};
}

// Surface of a solid, for the light tree: of an ellipsoid within 1.1 % (Knud Thomsen), of a sheared cylinder
// within its shear.
double areaOf(ShapeKind kind, const glm::dmat3& m) {
  const double pi = std::numbers::pi;
  const double xy = glm::length(glm::cross(m[0], m[1])), yz = glm::length(glm::cross(m[1], m[2])),
               zx = glm::length(glm::cross(m[2], m[0]));
  if (kind == boxes) return 8.0 * (xy + yz + zx);
  if (kind == cylinders) return 2.0 * pi * (zx + xy + yz);
  constexpr double p = 1.6075;
  const double mean = (std::pow(xy, p) + std::pow(yz, p) + std::pow(zx, p)) / 3.0;
  return 4.0 * pi * std::pow(mean, 1.0 / p);
}

std::uint32_t solidLightKind(ShapeKind kind) {
  return kind == boxes ? LIGHT_BOX : kind == cylinders ? LIGHT_CYLINDER : LIGHT_ELLIPSOID;
}

}  // namespace

void LightRows::addPunctual(const Light& light, const glm::dmat4& world, const glm::dvec3& origin) {
  const glm::vec3 intensity = lightColor(light) * light.intensity;
  const glm::vec3 position(glm::dvec3(world[3]) - origin);
  const glm::vec3 axis(-glm::normalize(glm::dvec3(world[2])));
  if (const auto* directional = std::get_if<DirectionalLight>(&light.kind)) {
    const bool sun = directional->angularDiameter > 0.0f;
    pushDirectional(sun ? suns_ : others_, *directional, axis, intensity);
    features_ |= sun ? FEATURE_DIRECTIONAL_LIGHTS | FEATURE_SUNS : FEATURE_DIRECTIONAL_LIGHTS;
  } else if (const auto* spot = std::get_if<SpotLight>(&light.kind)) {
    pushSpot(others_, *spot, position, intensity, axis);
    features_ |= FEATURE_SPOT_LIGHTS;
  } else if (std::holds_alternative<PointLight>(light.kind)) {
    others_.insert(others_.end(), {glm::vec4(position, float(LIGHT_POINT)), glm::vec4(intensity, 0.0f),
                                   glm::vec4(0.0f), glm::vec4(0.0f)});
    features_ |= FEATURE_POINT_LIGHTS;
  }
}

std::uint32_t LightRows::addEmitter(ShapeKind kind, const Placement& place, const glm::vec3& radiance,
                                    bool oneSided, std::uint32_t primitive) {
  const std::uint32_t index = count();
  const float self = bits(primitive);
  const glm::vec3 centre(place.centre);
  if (kind == spheres || kind == largeSpheres) {
    const float radius = float(place.worldFromUnit[0][0]);
    others_.insert(others_.end(), {glm::vec4(centre, float(LIGHT_SPHERE)), glm::vec4(radiance, radius),
                                   glm::vec4(0.0f), glm::vec4(0.0f, 0.0f, 0.0f, self)});
  } else if (kind == rects || kind == disks) {
    const FlatAxes axes = flatAxes(place.worldFromUnit);
    others_.insert(others_.end(), {glm::vec4(centre, float(kind == rects ? LIGHT_RECT : LIGHT_DISK)),
                                   glm::vec4(radiance, oneSided ? 0.0f : 1.0f),
                                   glm::vec4(glm::vec3(axes.u), 0.0f), glm::vec4(glm::vec3(axes.v), self)});
  } else {
    return NO_LIGHT;
  }
  features_ |= FEATURE_AREA_LIGHTS;
  return index;
}

std::uint32_t LightRows::addBody(const Body& body, const glm::vec3& radiance) {
  const std::uint32_t index = count();
  const glm::vec3 low(body.box.low[0], body.box.low[1], body.box.low[2]),
      high(body.box.high[0], body.box.high[1], body.box.high[2]);
  others_.insert(others_.end(),
                 {glm::vec4(0.5f * (low + high), float(body.kind)), glm::vec4(radiance, 1.0f),
                  glm::vec4(0.5f * (high - low), float(body.area)),
                  glm::vec4(bits(body.row), bits(body.triangles), 0.0f, bits(body.primitive))});
  features_ |= FEATURE_AREA_LIGHTS;
  return index;
}

std::uint32_t LightRows::addSolid(ShapeKind kind, const Placement& place, const glm::vec3& radiance,
                                  std::uint32_t primitive, std::uint32_t shapeRow) {
  solids_ |= 1u << (solidLightKind(kind) - LIGHT_BOX);
  const double area = areaOf(kind, place.worldFromUnit);
  return addBody({solidLightKind(kind), boxOf(kind, place), area, shapeRow, 0, primitive}, radiance);
}

std::uint32_t LightRows::addMesh(const MeshLight& mesh, const Bounds& box, const glm::vec3& radiance,
                                 std::uint32_t primitive) {
  mostTriangles_ = std::max(mostTriangles_, mesh.triangles);
  return addBody({LIGHT_MESH, box, mesh.area, mesh.triangleRow, mesh.triangles, primitive}, radiance);
}

std::uint32_t LightRows::count() const {
  return std::uint32_t((suns_.size() + others_.size()) / LIGHT_ROWS);
}

std::uint32_t LightRows::sunCount() const {
  return std::uint32_t(suns_.size() / LIGHT_ROWS);
}

Rows LightRows::rows() const {
  Rows all = suns_;
  all.insert(all.end(), others_.begin(), others_.end());
  return all;
}

}  // namespace steradian
