// SPDX-License-Identifier: MIT
#include "renderer/variants.hpp"

#include <algorithm>
#include <bit>
#include <chrono>

#include "renderer/gpu/commands.hpp"
#include "renderer/shader_code.hpp"
#include "renderer/specialize.hpp"
#include "renderer/stopwatch.hpp"

namespace steradian {
namespace {

using namespace gpu;

// CPU drivers run both sides of a branch, so separate loops for nodes and for triangles pay there.
Specialization loopForm(const Device& device) {
  return {CONSTANT_WHILE_WHILE, device.description().type == "CPU" ? 1u : 0u};
}

}  // namespace

std::vector<Specialization> constantsOf(const Device& device, const VariantKey& key) {
  std::vector<Specialization> constants;
  for (std::uint32_t i = 0; i < FEATURE_COUNT; ++i) constants.push_back({i, (key.features >> i) & 1u});
  constants.push_back({CONSTANT_FIXED_SPHERES, key.fixedSpheres});
  constants.push_back({CONSTANT_FIXED_PLANES, key.fixedPlanes});
  constants.push_back({CONSTANT_FIXED_LIGHTS, key.fixedLights});
  constants.push_back({CONSTANT_PLANE_AXES, key.planeAxes});
  constants.push_back({CONSTANT_ABLATION, key.ablation ? 1u : 0u});
  constants.push_back({CONSTANT_ONE_INSTANCE, key.oneInstance ? 1u : 0u});
  constants.push_back({CONSTANT_SHAPE_HIERARCHY, key.shapeHierarchy ? 1u : 0u});
  constants.push_back({CONSTANT_MESH_LIGHTS, key.meshLights ? 1u : 0u});
  for (std::uint32_t i = 0; i < SOLID_LIGHT_KINDS; ++i)
    constants.push_back({CONSTANT_SOLID_LIGHTS + i, (key.solidLights >> i) & 1u});
  constants.push_back(loopForm(device));
  return constants;
}

namespace {

std::unique_ptr<ComputePass> compile(const Device& device, const VariantKey& key) {
  const std::vector<Specialization> constants = constantsOf(device, key);
  const std::vector<std::uint32_t> own = specialized(pathTraceSpirv(), constants);
  if (own.empty()) return std::make_unique<ComputePass>(device, pathTraceSpirv(), constants, "path_trace");
  return std::make_unique<ComputePass>(device, own, std::span<const Specialization>{}, "path_trace");
}

// What the generic variants know, each more than the one before.
constexpr std::uint32_t basicFeatures =
    FEATURE_SPHERES | FEATURE_PLANES | FEATURE_LARGE_SPHERES | FEATURE_BOXES | FEATURE_RECTS | FEATURE_DISKS |
    FEATURE_CYLINDERS | FEATURE_ELLIPSOIDS | FEATURE_POINT_LIGHTS | FEATURE_SPOT_LIGHTS |
    FEATURE_DIRECTIONAL_LIGHTS | FEATURE_EMISSION | FEATURE_DIFFUSE | FEATURE_GLOSSY | FEATURE_MIRROR |
    FEATURE_COMPENSATION | FEATURE_ROULETTE;
constexpr std::uint32_t analyticFeatures = ~(FEATURE_MESHES | FEATURE_TEXTURES | FEATURE_ALPHA);
constexpr std::uint32_t genericFeatures[] = {basicFeatures, analyticFeatures, ~0u};

}  // namespace

void dispatchNothing(const Device& device, const ComputePass& pass) {
  const Bindings bindings(device, {}, {});
  const TraceParams nothing{};
  device.run(QueueKind::compute, [&](const auto& cmd) { pass.dispatch(cmd, bindings, nothing, 1, 1); });
}

void warmDriverCache(const Device& device, const VariantKey& key) {
  if (device.description().type != "CPU") return;
  const auto scratch = openDevice({.device = std::to_string(device.description().index)});
  dispatchNothing(*scratch, *compile(*scratch, key));
}

bool VariantKey::covers(const VariantKey& needed) const {
  const auto serves = [](std::uint32_t own, std::uint32_t asked) { return own == 0 || own == asked; };
  return (needed.features & ~features) == 0 && serves(fixedSpheres, needed.fixedSpheres) &&
         serves(fixedPlanes, needed.fixedPlanes) && serves(fixedLights, needed.fixedLights) &&
         serves(planeAxes, needed.planeAxes) && serves(oneInstance, needed.oneInstance) &&
         shapeHierarchy == needed.shapeHierarchy && meshLights == needed.meshLights &&
         (needed.solidLights & ~solidLights) == 0 && ablation == needed.ablation;
}

VariantKey genericFor(const VariantKey& needed) {
  VariantKey generic;
  generic.features =
      *std::ranges::find_if(genericFeatures, [&](auto known) { return (needed.features & ~known) == 0; });
  generic.shapeHierarchy = needed.shapeHierarchy;
  generic.meshLights = needed.meshLights;
  generic.solidLights = needed.solidLights != 0 ? (1u << SOLID_LIGHT_KINDS) - 1u : 0u;
  return generic;
}

namespace {

// 0 of a plane that faces no axis exactly, else 1 + the axis, and 3 more for its negative side.
std::uint32_t facingOf(const glm::vec4& plane) {
  std::uint32_t facing = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(plane[axis]) == 1.0f) facing = 1u + std::uint32_t(axis) + (plane[axis] < 0.0f ? 3u : 0u);
  return glm::abs(plane.x) + glm::abs(plane.y) + glm::abs(plane.z) == 1.0f ? facing : 0u;
}

std::uint32_t planeAxes(const GpuScene& scene) {
  const std::size_t first = CAMERA_ROWS + FILTER_ROWS + scene.params.sphereCount;
  std::uint32_t axes = 0;
  for (std::uint32_t i = 0; i < scene.params.planeCount; ++i)
    axes |= facingOf(scene.rows[first + i]) << (3 * i);
  return axes;
}

}  // namespace

VariantKey variantFor(const GpuScene& scene, std::uint32_t lightSamples) {
  const TraceParams& p = scene.params;
  VariantKey key{scene.features};
  key.shapeHierarchy = scene.shapeHierarchy();
  key.meshLights = scene.meshLights;
  key.solidLights = scene.solidLights;
  const std::uint32_t listedSpheres = key.shapeHierarchy ? 0 : p.sphereCount;
  if (listedSpheres <= MAX_FIXED && p.planeCount <= MAX_FIXED) {
    key.fixedSpheres = listedSpheres;
    key.fixedPlanes = p.planeCount;
    key.planeAxes = planeAxes(scene);
  }
  key.oneInstance = scene.oneInstance();
  // Every baked light is one more copy of the traversal, which is long where there are meshes.
  const std::uint32_t mostBaked = p.instanceCount > 0 ? 1u : MAX_FIXED_LIGHTS;
  if (p.lightCount <= std::min(mostBaked, lightSamples)) key.fixedLights = p.lightCount;
  // The loop budget may allow fewer light samples than were asked for.
  if (p.lightCount > lightSamples) key.features |= FEATURE_LIGHT_TREE;
  return key;
}

VariantInfo describeVariant(const VariantKey& key) {
  static const char* const names[FEATURE_COUNT] = {"spheres",
                                                   "planes",
                                                   "large spheres",
                                                   "boxes",
                                                   "rects",
                                                   "disks",
                                                   "cylinders",
                                                   "ellipsoids",
                                                   "point lights",
                                                   "spot lights",
                                                   "directional lights",
                                                   "emission",
                                                   "diffuse",
                                                   "glossy",
                                                   "mirror",
                                                   "alpha",
                                                   "area lights",
                                                   "suns",
                                                   "environment",
                                                   "sampled sky",
                                                   "light tree",
                                                   "transmission",
                                                   "absorption",
                                                   "clearcoat",
                                                   "edge tint",
                                                   "energy compensation",
                                                   "lens",
                                                   "orthographic",
                                                   "Russian roulette",
                                                   "clamp",
                                                   "meshes",
                                                   "textures"};
  VariantInfo info;
  info.specialized = key != genericFor(key);
  for (std::uint32_t i = 0; i < FEATURE_COUNT; ++i)
    ((key.features >> i) & 1u ? info.features : info.leftOut).push_back(names[i]);
  if (key.shapeHierarchy) info.features.push_back("shape hierarchy");
  if (key.meshLights) info.features.push_back("mesh lights");
  if (key.solidLights) info.features.push_back("solid lights");
  if (key.fixedSpheres) info.features.push_back(std::to_string(key.fixedSpheres) + " spheres baked");
  if (key.fixedPlanes) info.features.push_back(std::to_string(key.fixedPlanes) + " planes baked");
  if (key.fixedLights) info.features.push_back(std::to_string(key.fixedLights) + " lights baked");
  return info;
}

Variants::Variants(std::shared_ptr<gpu::Device> device)
    : device_(std::move(device)), worker_([this](std::stop_token stop) { work(stop); }) {}

Variants::~Variants() {
  worker_.request_stop();
  changed_.notify_all();
}

const Variants::Special* Variants::find(const VariantKey& needed) const {
  const Special* best = nullptr;
  for (const Special& s : ready_) {
    if (s.key == needed) return &s;
    const bool smaller = !best || std::popcount(s.key.features) < std::popcount(best->key.features);
    if (smaller && s.key.covers(needed)) best = &s;
  }
  return best;
}

const Variants::Special* Variants::add(const VariantKey& key, std::unique_ptr<ComputePass> pass,
                                       double seconds) {
  compileSeconds_ += seconds;
  ready_.push_front({key, std::move(pass)});
  return &ready_.front();
}

const Variants::Special* Variants::compileGeneric(const VariantKey& key, std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  const auto start = std::chrono::steady_clock::now();
  auto pass = compile(*device_, key);
  const double seconds = secondsSince(start);
  lock.lock();
  return add(key, std::move(pass), seconds);
}

void Variants::want(const VariantKey& key) {
  if (std::ranges::find(wanted_, key) != wanted_.end() || std::ranges::find(failed_, key) != failed_.end())
    return;
  // Only the newest wish counts: a drag that adds and removes kinds must not queue up compilations.
  if (wanted_.size() > 1) wanted_.resize(1);
  wanted_.push_back(key);
  changed_.notify_all();
}

Variants::Choice Variants::choose(const VariantKey& needed) {
  std::unique_lock lock(mutex_);
  const VariantKey generic = genericFor(needed);
  const bool special = allowSpecial_ || needed.ablation;
  const Special* found = find(special ? needed : generic);
  if (special && (!found || found->key != needed)) want(needed);
  if (!found) found = find(generic);
  if (!found) found = compileGeneric(generic, lock);
  return {found->pass.get(), found->key};
}

void Variants::waitFor(const VariantKey& needed) {
  choose(needed);
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return settled(needed); });
}

bool Variants::settled(const VariantKey& needed) const {
  return (!allowSpecial_ && !needed.ablation) ||
         std::ranges::find(ready_, needed, &Special::key) != ready_.end() ||
         std::ranges::find(failed_, needed) != failed_.end();
}

bool Variants::awaits(const VariantKey& needed) {
  const std::lock_guard lock(mutex_);
  if (settled(needed)) return false;
  want(needed);
  return true;
}

void Variants::allowSpecial(bool allow) {
  const std::lock_guard lock(mutex_);
  allowSpecial_ = allow;
}

double Variants::compileSeconds() const {
  const std::lock_guard lock(mutex_);
  return compileSeconds_;
}

void Variants::finished(const VariantKey& key, std::unique_ptr<ComputePass> pass, double seconds) {
  const std::lock_guard lock(mutex_);
  std::erase(wanted_, key);
  if (pass) {
    add(key, std::move(pass), seconds);
  } else {
    failed_.push_back(key);
  }
  changed_.notify_all();
}

void Variants::work(std::stop_token stop) {
  while (true) {
    VariantKey key;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [&] { return !wanted_.empty(); })) return;
      key = wanted_.back();
    }
    const auto start = std::chrono::steady_clock::now();
    std::unique_ptr<ComputePass> pass;
    try {
      warmDriverCache(*device_, key);
      pass = compile(*device_, key);
      dispatchNothing(*device_, *pass);
    } catch (const Error&) {
      pass.reset();  // the generic variant stays in use
    }
    finished(key, std::move(pass), secondsSince(start));
  }
}

}  // namespace steradian
