// SPDX-License-Identifier: MIT
#include "renderer/scene_cache.hpp"

#include <set>

#include "renderer/gpu_environment.hpp"
#include "renderer/gpu_materials.hpp"

namespace steradian {
namespace {

/// A thing to make, and about how long it takes beside the others.
struct Work {
  double cost = 0.0;
  std::function<void()> make;
};

/// Collects each source once.
class Plan {
 public:
  explicit Plan(SceneCache& cache) : cache_(cache) {}

  void add(const std::shared_ptr<const Mesh>& mesh) {
    if (!seen_.insert(mesh.get()).second) return;
    constexpr double costPerTriangle = 8.0;  // of a texel's
    work.push_back({costPerTriangle * double(mesh->triangles.size()), [&cache = cache_, mesh] {
                      cache.meshes.of(mesh);
                      cache.meshes.verticesOf(mesh);
                    }});
  }
  void add(const TextureSlot& slot, bool srgb) {
    if (!isUsable(slot) || !seenTextures_.emplace(slot.texture.get(), srgb).second) return;
    const TexturePixels& p = slot.texture->pixels;
    work.push_back({double(p.width) * p.height,
                    [&cache = cache_, texture = slot.texture, srgb] { cache.textures.of(texture, srgb); }});
  }
  void add(const std::shared_ptr<const Image>& sky) {
    if (!sky || !seen_.insert(sky.get()).second) return;
    work.push_back({double(sky->width) * sky->height, [&cache = cache_, sky] { cache.skyOf(sky); }});
  }
  /// Seen as any object may show it; a table that none needs costs little.
  void add(const Material& material) {
    if (!isRoughGlass(materialBits(material, {})) || !seenGlass_.insert(material.ior).second) return;
    constexpr double cost = 1e6;
    work.push_back({cost, [&cache = cache_, ior = material.ior] { cache.glass.of(ior); }});
  }

  std::vector<Work> work;

 private:
  SceneCache& cache_;
  std::set<const void*> seen_;
  std::set<std::pair<const Texture*, bool>> seenTextures_;
  std::set<float> seenGlass_;
};

std::vector<Work> workOf(const Scene& scene, SceneCache& cache) {
  Plan plan(cache);
  for (const Object& object : scene.objects) {
    if (const auto* geometry = std::get_if<Geometry>(&object.content))
      if (const auto* shape = std::get_if<MeshShape>(&geometry->shape)) plan.add(shape->mesh);
    if (const auto* light = std::get_if<Light>(&object.content))
      if (const auto* sky = std::get_if<EnvironmentLight>(&light->kind)) plan.add(sky->image);
  }
  for (const Material& m : scene.materials) {
    plan.add(m.albedoTexture, true);
    plan.add(m.metallicRoughnessTexture, false);
    plan.add(m.normalTexture, false);
    plan.add(m.emissionTexture, true);
    if (scene.render.energyCompensation) plan.add(m);
  }
  return std::move(plan.work);
}

}  // namespace

std::shared_ptr<const std::vector<glm::vec4>> SceneCache::skyOf(const std::shared_ptr<const Image>& image) {
  skies_.forgetUnused();
  return skies_.of(image, [&] { return environmentTables(*image); });
}

void SceneCache::prepare(const Scene& scene, const std::function<bool(double)>& goOn) {
  const std::vector<Work> all = workOf(scene, *this);
  double total = 0.0, done = 0.0;
  for (const Work& each : all) total += each.cost;
  for (const Work& each : all) {
    if (!goOn(total > 0.0 ? done / total : 0.0)) return;
    each.make();
    done += each.cost;
  }
}

}  // namespace steradian
