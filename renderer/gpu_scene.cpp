// SPDX-License-Identifier: MIT
#include "renderer/gpu_scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "renderer/gpu_shapes.hpp"
#include "renderer/pixel_filter.hpp"

namespace steradian {
namespace {

using namespace gpu;

constexpr float mirrorAlpha = 1e-3f;  // MIRROR_ALPHA in bsdf.glsl
// Planet-sized beside what stands on it, or in absolute terms: double-float needed.
constexpr double largeRadiusMetres = 100.0, largeRadiusFactor = 1000.0;

std::vector<glm::vec4> cameraRows(const CameraView& view) {
  const glm::dmat4& m = view.worldFromCamera;
  return {glm::vec4(glm::vec3(m[0]), 0.0f), glm::vec4(glm::vec3(m[1]), 0.0f),
          glm::vec4(glm::vec3(-m[2]), 0.0f)};
}

std::vector<glm::vec4> tabulated(const std::vector<double>& table) {
  std::vector<glm::vec4> made;
  for (std::uint32_t i = 0; i < FILTER_ROWS; ++i)
    made.emplace_back(float(table[i]), float(table[i + 1] - table[i]), 0.0f, 0.0f);
  return made;
}

// The generic variant always reads the table, so it must hold the box too.
const std::vector<glm::vec4>& filterRows(PixelFilter filter) {
  static const std::vector<glm::vec4> box = tabulated(boxInverseCdf(FILTER_ROWS));
  static const std::vector<glm::vec4> blackmanHarris = tabulated(blackmanHarrisInverseCdf(FILTER_ROWS));
  return filter == PixelFilter::box ? box : blackmanHarris;
}

std::uint32_t featuresOf(const Material& m) {
  const float alpha = m.roughness * m.roughness;
  const bool specular = m.metallic > 0.0f || m.specular > 0.0f;
  return (m.metallic < 1.0f ? FEATURE_DIFFUSE : 0u) |
         (specular && alpha >= mirrorAlpha ? FEATURE_GLOSSY : 0u) |
         (specular && alpha < mirrorAlpha ? FEATURE_MIRROR : 0u) |
         (m.emissionLuminance > 0.0f ? FEATURE_EMISSION : 0u);
}

void pushMaterial(std::vector<glm::vec4>& rows, const Material& m) {
  const float ratio = (m.ior - 1.0f) / (m.ior + 1.0f);
  const float dielectricF0 = m.specular * ratio * ratio;
  rows.emplace_back(m.albedo, m.metallic);
  rows.emplace_back(m.roughness * m.roughness, dielectricF0, m.specular, std::bit_cast<float>(featuresOf(m)));
  rows.emplace_back(m.emissionColor * m.emissionLuminance, 0.0f);
}

std::uint32_t pushLight(std::vector<glm::vec4>& rows, const Light& light, const glm::dmat4& world,
                        const glm::dvec3& origin) {
  const glm::vec3 intensity = light.color * light.intensity;
  const glm::vec3 position(glm::dvec3(world[3]) - origin);
  const glm::vec3 axis(-glm::normalize(glm::dvec3(world[2])));
  if (const auto* spot = std::get_if<SpotLight>(&light.kind)) {
    const double cosOuter = std::cos(double(spot->outerConeAngle));
    const double scale = 1.0 / std::max(1e-3, std::cos(double(spot->innerConeAngle)) - cosOuter);
    rows.insert(rows.end(), {glm::vec4(position, float(LIGHT_SPOT)), glm::vec4(intensity, float(scale)),
                             glm::vec4(axis, float(-cosOuter * scale))});
    return FEATURE_SPOT_LIGHTS;
  }
  const bool directional = std::holds_alternative<DirectionalLight>(light.kind);
  rows.emplace_back(directional ? -axis : position, float(directional ? LIGHT_DIRECTIONAL : LIGHT_POINT));
  rows.emplace_back(intensity, 0.0f);
  rows.emplace_back(0.0f);
  return directional ? FEATURE_DIRECTIONAL_LIGHTS : FEATURE_POINT_LIGHTS;
}

struct Placed {
  const Object* object;
  glm::dmat4 world;
};

std::vector<Placed> visibleObjects(const Scene& scene) {
  const std::vector<glm::dmat4> world = worldTransforms(scene);
  const std::vector<bool> visible = hierarchyVisibility(scene);
  std::vector<Placed> placed;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (visible[i]) placed.push_back({&scene.objects[i], world[i]});
  return placed;
}

double largeRadiusOf(const std::vector<Placed>& objects) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Placed& p : objects)
    if (const auto* g = std::get_if<Geometry>(&p.object->content))
      smallest = std::min(smallest, smallestExtent(g->shape, p.world));
  return std::min(largeRadiusMetres, largeRadiusFactor * smallest);
}

void appendShapes(GpuScene& out, const ShapeLists& lists) {
  std::uint32_t* const counts[] = {&out.params.sphereCount,      &out.params.planeCount,
                                   &out.params.largeSphereCount, &out.params.boxCount,
                                   &out.params.rectCount,        &out.params.diskCount,
                                   &out.params.cylinderCount,    &out.params.ellipsoidCount};
  for (int k = 0; k < shapeKinds; ++k) {
    const ShapeList& list = lists.kinds[k];
    *counts[k] = std::uint32_t(list.links.size());
    out.rows.insert(out.rows.end(), list.rows.begin(), list.rows.end());
    if (!list.links.empty()) out.features |= 1u << k;
  }
}

std::vector<SurfaceLink> linksInOrder(const ShapeLists& lists) {
  std::vector<SurfaceLink> links;
  for (const ShapeList& list : lists.kinds) links.insert(links.end(), list.links.begin(), list.links.end());
  if (links.empty()) links.push_back({Id::none, Id::none});  // an empty scene still reads a row
  return links;
}

void appendSurfaces(GpuScene& out, const Scene& scene, const std::vector<SurfaceLink>& links) {
  static const Material standard;
  out.params.materialRow = std::uint32_t(out.rows.size());
  for (const SurfaceLink& link : links) {
    const Material* material = findMaterial(scene, link.material);
    pushMaterial(out.rows, material ? *material : standard);
    out.features |= featuresOf(material ? *material : standard);
  }
  out.params.objectRow = std::uint32_t(out.rows.size());
  for (const SurfaceLink& link : links)
    out.rows.emplace_back(std::bit_cast<float>(std::uint32_t(link.object)), 0.0f, 0.0f, 0.0f);
}

void applySettings(GpuScene& out, const RenderSettings& s) {
  out.params.seed = s.seed;
  out.params.maxBounces = std::uint32_t(std::clamp(s.maxBounces, 0, 64));
  out.params.lightSamples = std::uint32_t(std::clamp(s.lightSamples, 1, int(MAX_LIGHT_SAMPLES)));
  out.params.flags =
      (s.errorMeter ? TRACE_ERROR_METER : 0u) | (s.russianRoulette ? TRACE_RUSSIAN_ROULETTE : 0u);
  if (s.filter == PixelFilter::blackmanHarris) out.features |= FEATURE_FILTER_TABLE;
}

}  // namespace

bool GpuScene::sameRadiance(const GpuScene& other) const {
  return rows.size() == other.rows.size() && features == other.features &&
         std::memcmp(&params, &other.params, sizeof params) == 0 &&
         std::memcmp(rows.data(), other.rows.data(), rows.size() * sizeof(glm::vec4)) == 0;
}

GpuScene packScene(const Scene& scene, const CameraView& view, Extent film) {
  GpuScene out;
  out.origin = glm::dvec3(view.worldFromCamera[3]);
  out.params.width = std::uint32_t(film.width);
  out.params.height = std::uint32_t(film.height);
  out.params.pixelScale = float(2.0 * std::tan(0.5 * view.fovY) / film.height);
  out.rows = cameraRows(view);
  const std::vector<glm::vec4>& filter = filterRows(scene.render.filter);
  out.rows.insert(out.rows.end(), filter.begin(), filter.end());

  const std::vector<Placed> objects = visibleObjects(scene);
  const double largeRadius = largeRadiusOf(objects);
  ShapeLists shapes;
  std::vector<glm::vec4> lights;
  for (const Placed& p : objects) {
    if (const auto* g = std::get_if<Geometry>(&p.object->content)) {
      shapes.add(g->shape, p.world, out.origin, {g->material, p.object->id}, largeRadius);
    } else if (const auto* light = std::get_if<Light>(&p.object->content)) {
      out.features |= pushLight(lights, *light, p.world, out.origin);
    }
  }
  appendShapes(out, shapes);
  appendSurfaces(out, scene, linksInOrder(shapes));
  out.params.lightRow = std::uint32_t(out.rows.size());
  out.params.lightCount = std::uint32_t(lights.size() / LIGHT_ROWS);
  out.rows.insert(out.rows.end(), lights.begin(), lights.end());
  applySettings(out, scene.render);
  return out;
}

}  // namespace steradian
