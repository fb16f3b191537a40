// SPDX-License-Identifier: MIT
#include "renderer/variants.hpp"

#include <algorithm>
#include <chrono>

#include "renderer/gpu/commands.hpp"
#include "renderer/shader_code.hpp"

namespace steradian {
namespace {

using namespace gpu;
constexpr std::size_t maxReady = 16;

std::vector<Specialization> constantsOf(const VariantKey& key) {
  std::vector<Specialization> constants;
  for (std::uint32_t i = 0; i < FEATURE_COUNT; ++i) constants.push_back({i, (key.features >> i) & 1u});
  constants.push_back({CONSTANT_FIXED_SPHERES, key.fixedSpheres});
  constants.push_back({CONSTANT_FIXED_PLANES, key.fixedPlanes});
  constants.push_back({CONSTANT_FIXED_LIGHTS, key.fixedLights});
  constants.push_back({CONSTANT_ABLATION, key.ablation ? 1u : 0u});
  return constants;
}

std::unique_ptr<ComputePass> compile(const Device& device, const VariantKey& key) {
  return std::make_unique<ComputePass>(device, pathTraceSpirv(), constantsOf(key), "path_trace (special)");
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// One dispatch that touches no pixel: some drivers only compile to machine code at the first one.
void dispatchNothing(const Device& device, const ComputePass& pass) {
  const Bindings bindings(device, nullptr, {});
  const TraceParams nothing{};
  device.run(QueueKind::compute, [&](const auto& cmd) { pass.dispatch(cmd, bindings, nothing, 1, 1); });
}

}  // namespace

bool VariantKey::covers(const VariantKey& needed) const {
  return (needed.features & ~features) == 0 && fixedSpheres == needed.fixedSpheres &&
         fixedPlanes == needed.fixedPlanes && fixedLights == needed.fixedLights &&
         ablation == needed.ablation;
}

VariantKey variantFor(const GpuScene& scene, std::uint32_t lightSamples) {
  const TraceParams& p = scene.params;
  VariantKey key{scene.features};
  if (p.sphereCount <= MAX_FIXED && p.planeCount <= MAX_FIXED) {
    key.fixedSpheres = p.sphereCount;
    key.fixedPlanes = p.planeCount;
  }
  if (p.lightCount <= std::min(MAX_FIXED_LIGHTS, lightSamples)) key.fixedLights = p.lightCount;
  // The loop budget may allow fewer light samples than were asked for.
  if (p.lightCount > lightSamples) key.features |= FEATURE_LIGHT_TREE;
  return key;
}

VariantInfo describeVariant(const std::optional<VariantKey>& key) {
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
                                                   "filter table",
                                                   "area lights",
                                                   "suns",
                                                   "environment",
                                                   "environment image",
                                                   "light tree",
                                                   "transmission",
                                                   "absorption",
                                                   "clearcoat",
                                                   "edge tint",
                                                   "energy compensation",
                                                   "lens",
                                                   "orthographic",
                                                   "Russian roulette",
                                                   "clamp"};
  VariantInfo info;
  info.specialized = key.has_value();
  for (std::uint32_t i = 0; i < FEATURE_COUNT; ++i)
    (!key || (key->features >> i) & 1u ? info.features : info.leftOut).push_back(names[i]);
  if (key && key->fixedSpheres) info.features.push_back(std::to_string(key->fixedSpheres) + " spheres baked");
  if (key && key->fixedPlanes) info.features.push_back(std::to_string(key->fixedPlanes) + " planes baked");
  if (key && key->fixedLights) info.features.push_back(std::to_string(key->fixedLights) + " lights baked");
  return info;
}

Variants::Variants(std::shared_ptr<gpu::Device> device) : device_(std::move(device)) {
  const auto start = std::chrono::steady_clock::now();
  generic_ = std::make_unique<ComputePass>(*device_, pathTraceSpirv(), std::span<const Specialization>{},
                                           "path_trace (generic)");
  compileSeconds_ = secondsSince(start);
  worker_ = std::jthread([this](std::stop_token stop) { work(stop); });
}

Variants::~Variants() {
  worker_.request_stop();
  changed_.notify_all();
}

const Variants::Special* Variants::find(const VariantKey& needed) const {
  const auto exact = std::ranges::find(ready_, needed, &Special::key);
  if (exact != ready_.end()) return &*exact;
  const auto wider = std::ranges::find_if(ready_, [&](const Special& s) { return s.key.covers(needed); });
  return wider != ready_.end() ? &*wider : nullptr;
}

Variants::Choice Variants::choose(const VariantKey& needed) {
  const std::lock_guard lock(mutex_);
  if (!allowSpecial_ && !needed.ablation) return {generic_.get(), {}};
  const Special* found = find(needed);
  const bool exact = found && found->key == needed;
  if (!exact && std::ranges::find(wanted_, needed) == wanted_.end() &&
      std::ranges::find(failed_, needed) == failed_.end()) {
    // Only the newest wish counts: a drag that adds and removes kinds must not queue up compilations.
    if (wanted_.size() > 1) wanted_.resize(1);
    wanted_.push_back(needed);
    changed_.notify_all();
  }
  if (!found) return {generic_.get(), {}};
  const auto at = std::ranges::find(ready_, found->key, &Special::key);
  ready_.splice(ready_.begin(), ready_, at);
  return {ready_.front().pass.get(), ready_.front().key};
}

void Variants::waitFor(const VariantKey& needed) {
  choose(needed);
  std::unique_lock lock(mutex_);
  if (!allowSpecial_ && !needed.ablation) return;
  changed_.wait(lock, [&] {
    return std::ranges::find(ready_, needed, &Special::key) != ready_.end() ||
           std::ranges::find(failed_, needed) != failed_.end();
  });
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
  compileSeconds_ += seconds;
  std::erase(wanted_, key);
  if (pass) {
    ready_.push_front({key, std::move(pass)});
  } else {
    failed_.push_back(key);
  }
  changed_.notify_all();
}

void Variants::warmDriverCache(const VariantKey& key) {
  // A CPU driver compiles on its only queue, which would stall the picture: let a second device do that, the
  // driver's disk cache then serves the first. Closing the device flushes that cache.
  if (device_->description().type != "CPU") return;
  const auto scratch = openDevice({.device = std::to_string(device_->description().index)});
  dispatchNothing(*scratch, *compile(*scratch, key));
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
      warmDriverCache(key);
      pass = compile(*device_, key);
      dispatchNothing(*device_, *pass);
    } catch (const Error&) {
      pass.reset();  // the generic variant stays in use
    }
    finished(key, std::move(pass), secondsSince(start));
  }
}

}  // namespace steradian
