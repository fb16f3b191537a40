// SPDX-License-Identifier: MIT
#include "renderer/gpu_scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "renderer/film_unit.hpp"
#include "renderer/gpu_environment.hpp"
#include "renderer/gpu_lights.hpp"
#include "renderer/gpu_materials.hpp"
#include "renderer/gpu_meshes.hpp"
#include "renderer/gpu_shapes.hpp"
#include "renderer/light_tree.hpp"
#include "renderer/pixel_filter.hpp"
#include "renderer/scene/inside.hpp"
#include "renderer/scene_cache.hpp"
#include "renderer/top_level.hpp"

namespace steradian {
namespace {

using namespace gpu;

// Planet-sized beside what stands on it, or in absolute terms: double-float needed.
constexpr double largeRadiusMetres = 100.0, largeRadiusFactor = 1000.0;

// The view's own field of view counts, not its camera's.
double lensRadius(const CameraView& view) {
  Camera lens = view.lens;
  lens.fovY = view.fovY;
  return apertureRadius(lens);
}

// Metres per pixel: at distance 1, or everywhere in parallel projection.
double pixelScale(const CameraView& view, Extent film) {
  if (view.lens.projection == Projection::orthographic) return view.lens.orthographicHeight / film.height;
  return 2.0 * std::tan(0.5 * view.fovY) / film.height;
}

std::vector<glm::vec4> cameraRows(const CameraView& view) {
  const glm::dmat4& m = view.worldFromCamera;
  const Camera& lens = view.lens;
  const bool parallel = lens.projection == Projection::orthographic;
  return {glm::vec4(glm::vec3(m[0]), float(lensRadius(view))),
          glm::vec4(glm::vec3(m[1]), float(lens.focusDistance)),
          glm::vec4(glm::vec3(-m[2]), parallel ? 1.0f : 0.0f), glm::vec4(0.0f)};
}

std::vector<glm::vec4> tabulated(const std::vector<double>& table) {
  std::vector<glm::vec4> made;
  for (std::uint32_t i = 0; i < FILTER_ROWS; ++i)
    made.emplace_back(float(table[i]), float(table[i + 1] - table[i]), 0.0f, 0.0f);
  return made;
}

const std::vector<glm::vec4>& filterRows(PixelFilter filter) {
  static const std::vector<glm::vec4> box = tabulated(boxInverseCdf(FILTER_ROWS));
  static const std::vector<glm::vec4> blackmanHarris = tabulated(blackmanHarrisInverseCdf(FILTER_ROWS));
  return filter == PixelFilter::box ? box : blackmanHarris;
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
  std::uint32_t* const counts[] = {
      &out.params.sphereCount,   &out.params.planeCount,     &out.params.largeSphereCount,
      &out.params.boxCount,      &out.params.rectCount,      &out.params.diskCount,
      &out.params.cylinderCount, &out.params.ellipsoidCount, &out.params.instanceCount};
  for (int k = 0; k < shapeKinds; ++k) {
    const ShapeList& list = lists.kinds[k];
    *counts[k] = std::uint32_t(list.links.size());
    out.rows.insert(out.rows.end(), list.rows.begin(), list.rows.end());
    if (!list.links.empty()) out.features |= k == instances ? FEATURE_MESHES : 1u << k;
  }
}

void appendCamera(GpuScene& out, const Scene& scene, const CameraView& view, Extent film) {
  out.origin = glm::dvec3(view.worldFromCamera[3]);
  out.params.width = std::uint32_t(film.width);
  out.params.height = std::uint32_t(film.height);
  out.params.pixelScale = float(pixelScale(view, film));
  out.rows = cameraRows(view);
  const std::vector<glm::vec4>& filter = filterRows(scene.render.filter);
  out.rows.insert(out.rows.end(), filter.begin(), filter.end());
  if (lensRadius(view) > 0.0) out.features |= FEATURE_LENS;
  if (view.lens.projection == Projection::orthographic) out.features |= FEATURE_ORTHOGRAPHIC;
}

// What the solids around the camera absorb, in the last of its rows.
void appendMedium(GpuScene& out, const Scene& scene, const std::vector<Placed>& objects) {
  glm::vec3 absorption(0.0f);
  for (const Placed& p : objects) {
    const auto* g = std::get_if<Geometry>(&p.object->content);
    if (g && holdsInside(g->shape, p.world, out.origin))
      absorption += absorptionOf(materialOf(scene, {g->material, p.object->id}));
  }
  out.rows[CAMERA_ROWS - 1] = glm::vec4(absorption, 0.0f);
}

// Solids may lie within each other: a ray adds what one absorbs on its way in and takes it away on its way
// out. As multiples of a 2^21st of the largest, up to eight coefficients do so exactly. A rest of rounding
// would hide the sky, which is endlessly far.
void roundAbsorption(GpuScene& out) {
  if ((out.features & FEATURE_ABSORPTION) == 0) return;
  std::vector<glm::vec4*> rows{&out.rows[CAMERA_ROWS - 1]};
  for (std::uint32_t row = out.params.materialRow; row < out.params.objectRow; row += MATERIAL_ROWS)
    rows.push_back(&out.rows[row + 4]);
  float largest = 0.0f;
  for (const glm::vec4* row : rows) largest = std::max({largest, row->x, row->y, row->z});
  const float quantum =
      std::max(std::exp2(std::floor(std::log2(largest)) - 20.0f), std::numeric_limits<float>::min());
  for (glm::vec4* row : rows)
    for (int c = 0; c < 3; ++c) (*row)[c] = std::round((*row)[c] / quantum) * quantum;
}

// Materials and object ids in the order of the primitives; emissive ones join the lights.
void appendSurfaces(GpuScene& out, const Scene& scene, const ShapeLists& shapes,
                    const InstanceList& instanceList, LightRows& lights, TexturePlaces& textures,
                    GlassPlaces& glass) {
  std::vector<glm::vec4> objects;
  for (const SurfaceLink& link : shapes.kinds[instances].links)
    textures.refs(materialOf(scene, link), out.rows);
  for (const ShapeList& list : shapes.kinds)
    for (const SurfaceLink& link : list.links) {
      const Material material = materialOf(scene, link);
      glass.rowOf(material, materialBits(material, link), out.rows);
    }
  out.params.materialRow = std::uint32_t(out.rows.size());
  std::uint32_t firstRow = CAMERA_ROWS + FILTER_ROWS;  // of the kind of shape
  const auto lightOf = [&](int kind, std::size_t i, const Placement& place, std::uint32_t bits,
                           const glm::vec3& radiance) {
    const auto primitive = std::uint32_t(objects.size());
    if ((bits & FEATURE_EMISSION) == 0 || radiance == glm::vec3(0.0f)) return NO_LIGHT;
    const bool oneSided = (bits & MATERIAL_ONE_SIDED) != 0;
    if (kind == boxes || kind == cylinders || kind == ellipsoids)
      return lights.addSolid(ShapeKind(kind), place, radiance, primitive,
                             firstRow + std::uint32_t(i) * AFFINE_ROWS);
    if (kind != instances) return lights.addEmitter(ShapeKind(kind), place, radiance, oneSided, primitive);
    return lights.addMesh(instanceList.lights[i], instanceList.boxes[i], radiance, primitive);
  };
  const auto append = [&](const SurfaceLink& link, int kind, std::size_t i, const Placement& place) {
    const Material material = materialOf(scene, link);
    const std::uint32_t bits = materialBits(material, link);
    const glm::vec3 radiance = material.emissionColor * material.emissionLuminance;
    const std::uint32_t light = lightOf(kind, i, place, bits, radiance);
    const TextureRefs refs = link.vertexFlags ? textures.refs(material, out.rows) : TextureRefs(0);
    pushMaterial(out.rows, material, bits, light, refs, glass.rowOf(material, bits, out.rows));
    out.features |= bits & ~MATERIAL_OWN_BITS;
    objects.emplace_back(std::bit_cast<float>(std::uint32_t(link.object)), 0.0f, 0.0f, 0.0f);
  };
  for (int kind = 0; kind < shapeKinds; ++kind) {
    for (std::size_t i = 0; i < shapes.kinds[kind].links.size(); ++i)
      append(shapes.kinds[kind].links[i], kind, i, shapes.kinds[kind].places[i]);
    firstRow += std::uint32_t(shapes.kinds[kind].rows.size());
  }
  if (objects.empty()) append({Id::none, Id::none}, planes, 0, {});  // an empty scene still reads a row
  out.params.objectRow = std::uint32_t(out.rows.size());
  out.rows.insert(out.rows.end(), objects.begin(), objects.end());
}

void appendLights(GpuScene& out, const LightRows& lights) {
  const std::vector<glm::vec4> rows = lights.rows();
  out.params.lightRow = std::uint32_t(out.rows.size());
  out.params.lightCount = lights.count();
  out.params.sunCount = lights.sunCount();
  out.features |= lights.features();
  out.meshLights = lights.mostTriangles() > 0;
  out.solidLights = lights.solids();
  out.rows.insert(out.rows.end(), rows.begin(), rows.end());
  const std::vector<glm::vec4> tree = lightTreeRows(rows);
  out.params.lightTreeRow = std::uint32_t(out.rows.size());
  out.rows.insert(out.rows.end(), tree.begin(), tree.end());
  if (out.params.lightCount > out.params.lightSamples) out.features |= FEATURE_LIGHT_TREE;
}

void appendEnvironment(GpuScene& out, const std::vector<Placed>& objects) {
  const Light* light = nullptr;
  glm::dmat4 world(1.0);
  for (const Placed& p : objects) {
    const auto* candidate = std::get_if<Light>(&p.object->content);
    if (light || !candidate || !std::holds_alternative<EnvironmentLight>(candidate->kind)) continue;
    light = candidate;
    world = p.world;
  }
  out.params.environmentRow = std::uint32_t(out.rows.size());
  const std::vector<glm::vec4> rows = environmentRows(light, world);
  out.rows.insert(out.rows.end(), rows.begin(), rows.end());
  if (!light) return;
  out.environment = std::get<EnvironmentLight>(light->kind).image;
  out.params.flags |= TRACE_ENVIRONMENT;
  out.features |= FEATURE_ENVIRONMENT | (skyIsSampled(*light) ? FEATURE_SAMPLED_SKY : 0u);
}

bool wantsHierarchy(const ShapeLists& shapes, ShapeSearch search) {
  if (search == ShapeSearch::list) return false;
  return listCost(shapes) >= (search == ShapeSearch::hierarchy ? 1 : spheresWorthAHierarchy);
}

void appendTopLevel(GpuScene& out, const ShapeLists& shapes, const InstanceList& instanceList,
                    ShapeSearch search) {
  const bool withShapes = wantsHierarchy(shapes, search);
  if (withShapes) out.params.flags |= TRACE_SHAPE_HIERARCHY;
  const TopLevel topLevel = buildTopLevel(topLevelEntries(shapes, instanceList, withShapes));
  out.params.topLevelRow = std::uint32_t(out.rows.size());
  out.rows.insert(out.rows.end(), topLevel.rows.begin(), topLevel.rows.end());
  out.traversalSteps = topLevel.worstSteps;
}

void applySettings(GpuScene& out, const RenderSettings& s) {
  out.params.seed = s.seed;
  out.params.maxBounces = std::uint32_t(std::clamp(s.maxBounces, 0, 64));
  out.params.lightSamples = std::uint32_t(std::clamp(s.lightSamples, 1, int(MAX_LIGHT_SAMPLES)));
  out.params.clampRadiance = s.clamp;
  out.params.flags = (s.errorMeter ? TRACE_ERROR_METER : 0u) |
                     (s.russianRoulette ? TRACE_RUSSIAN_ROULETTE : 0u) |
                     (s.energyCompensation ? TRACE_COMPENSATION : 0u);
  if (s.energyCompensation) out.features |= FEATURE_COMPENSATION;
  if (s.clamp > 0.0f) out.features |= FEATURE_CLAMP;
}

// How far paths go, which depends on whether there is something to meet.
void applyPathLength(GpuScene& out, bool russianRoulette) {
  constexpr std::uint32_t met = FEATURE_EMISSION | FEATURE_AREA_LIGHTS | FEATURE_SUNS | FEATURE_ENVIRONMENT;
  const bool meets = (out.features & met) != 0;
  if (meets) out.params.flags |= TRACE_MET_LIGHTS;
  const std::uint32_t lastBounce = out.params.maxBounces + (meets ? 1 : 0);  // path.glsl
  constexpr std::uint32_t roulettesFirstBounce = 3;                          // and there
  // The vertex before the last must play already.
  if (russianRoulette && lastBounce > roulettesFirstBounce) out.features |= FEATURE_ROULETTE;
}

}  // namespace

bool GpuScene::sameRadiance(const GpuScene& other) const {
  return rows.size() == other.rows.size() && features == other.features && environment == other.environment &&
         meshes == other.meshes && vertices == other.vertices && textures == other.textures &&
         std::memcmp(&params, &other.params, sizeof params) == 0 &&
         std::memcmp(rows.data(), other.rows.data(), rows.size() * sizeof(glm::vec4)) == 0;
}

bool GpuScene::shapeHierarchy() const {
  return (params.flags & TRACE_SHAPE_HIERARCHY) != 0;
}

bool GpuScene::oneInstance() const {
  return params.instanceCount == 1 && !shapeHierarchy();
}

GpuScene packScene(const Scene& scene, const CameraView& view, Extent film, ShapeSearch search) {
  SceneCache cache;
  return packScene(scene, view, film, cache, search);
}

GpuScene packScene(const Scene& scene, const CameraView& view, Extent film, SceneCache& cache,
                   ShapeSearch search) {
  GpuScene out;
  applySettings(out, scene.render);
  appendCamera(out, scene, view, film);
  const std::vector<Placed> objects = visibleObjects(scene);
  appendMedium(out, scene, objects);
  const double largeRadius = largeRadiusOf(objects);
  const MeshPlaces places(scene, cache.meshes);
  for (const MeshPlace& place : places.all()) {
    out.meshes.push_back(place.bvh);
    out.vertices.push_back(place.vertices);
  }
  TexturePlaces texturePlaces(scene, cache.textures);
  out.textures = texturePlaces.all();
  GlassPlaces glass(cache.glass, scene.render.energyCompensation);
  InstanceList instanceList;
  ShapeLists shapes;
  LightRows lights;
  for (const Placed& p : objects) {
    if (const auto* g = std::get_if<Geometry>(&p.object->content)) {
      if (const auto* m = std::get_if<MeshShape>(&g->shape))
        instanceList.add(places.of(*m->mesh), p.world, out.origin, {g->material, p.object->id});
      shapes.add(g->shape, p.world, out.origin, {g->material, p.object->id}, largeRadius);
    } else if (const auto* light = std::get_if<Light>(&p.object->content)) {
      shapes.addLight(*light, p.world, out.origin, p.object->id, largeRadius);
      lights.addPunctual(*light, p.world, out.origin);
    }
  }
  shapes.kinds[instances] = instanceList.shapes;
  appendShapes(out, shapes);
  appendSurfaces(out, scene, shapes, instanceList, lights, texturePlaces, glass);
  roundAbsorption(out);
  appendLights(out, lights);
  appendEnvironment(out, objects);
  appendTopLevel(out, shapes, instanceList, search);
  // The search for a triangle of a light, at every light's sample.
  out.traversalSteps += double(std::bit_width(lights.mostTriangles()));
  constexpr double manyVeils = 16.0;
  if ((out.features & FEATURE_ALPHA) != 0) out.traversals = manyVeils;
  applyPathLength(out, scene.render.russianRoulette);
  const float brightestTexel = out.environment ? cache.skyOf(out.environment)->front().y : 1.0f;
  out.filmUnit = filmUnit(brightestEmission(out, brightestTexel), scene.display);
  return out;
}

}  // namespace steradian
