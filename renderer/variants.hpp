// SPDX-License-Identifier: MIT
// Model only what a scene needs: a generic tracer starts at once, special ones are compiled on a worker
// thread and picked up between dispatches. All variants give the same samples.
#pragma once
#include <condition_variable>
#include <deque>
#include <list>
#include <memory>
#include <mutex>
#include <thread>

#include "renderer/gpu/pass.hpp"
#include "renderer/gpu_scene.hpp"

namespace steradian {

/// What a special variant was compiled for.
struct VariantKey {
  std::uint32_t features = 0;
  std::uint32_t fixedSpheres = 0, fixedPlanes = 0, fixedLights = 0;  // 0 = counted at run time
  std::uint32_t planeAxes = 0;    // that fixed planes face: CONSTANT_PLANE_AXES
  bool oneInstance = false;       // of a mesh
  bool shapeHierarchy = false;    // bounded shapes lie in the hierarchy
  bool meshLights = false;        // meshes are among the lights
  std::uint32_t solidLights = 0;  // bit i: CONSTANT_SOLID_LIGHTS + i
  bool ablation = false;          // obeys the flags of measurements
  bool operator==(const VariantKey&) const = default;
  /// Compiled for at least what `needed` asks; counts at run time serve any count.
  bool covers(const VariantKey& needed) const;
};

/// `lightSamples`: at each vertex, after the loop budget.
VariantKey variantFor(const GpuScene& scene, std::uint32_t lightSamples);
/// The smallest of a few generic variants that covers `needed`: what most scenes hold compiles and runs many
/// times faster than what any scene may hold.
VariantKey genericFor(const VariantKey& needed);
VariantInfo describeVariant(const VariantKey& key);
/// What the pipeline of `key` has compiled in on this device.
std::vector<gpu::Specialization> constantsOf(const gpu::Device& device, const VariantKey& key);

/// One dispatch that touches no pixel: some drivers make machine code only at the first one. Blocks.
void dispatchNothing(const gpu::Device& device, const gpu::ComputePass& pass);
/// A CPU driver makes machine code on its only queue, which would stall the picture: a second device does
/// that here, and through the driver's disk cache, which closing it flushes, `device` then only loads it.
/// Blocks; does nothing on other drivers. Throws Error.
void warmDriverCache(const gpu::Device& device, const VariantKey& key);

class Variants {
 public:
  explicit Variants(std::shared_ptr<gpu::Device> device);
  ~Variants();

  /// The best pass that is ready: exact, else the one of the fewest features that covers it; asks the worker
  /// for the exact one. Blocks to compile a generic one when nothing covers it; throws Error when that fails.
  struct Choice {
    const gpu::ComputePass* pass;
    VariantKey key;
  };
  Choice choose(const VariantKey& needed);
  /// Compile `needed` now unless it is there. Blocks.
  void waitFor(const VariantKey& needed);
  /// The same without blocking: false once `needed` is there, or cannot be had. Asks the worker for it.
  bool awaits(const VariantKey& needed);
  void allowSpecial(bool allow);
  double compileSeconds() const;

 private:
  struct Special {
    VariantKey key;
    std::unique_ptr<gpu::ComputePass> pass;
  };
  const Special* find(const VariantKey& needed) const;
  bool settled(const VariantKey& needed) const;  // ready, failed, or not allowed
  const Special* add(const VariantKey& key, std::unique_ptr<gpu::ComputePass> pass, double seconds);
  const Special* compileGeneric(const VariantKey& key, std::unique_lock<std::mutex>& lock);
  void want(const VariantKey& key);
  void work(std::stop_token stop);
  void finished(const VariantKey& key, std::unique_ptr<gpu::ComputePass> pass, double seconds);

  std::shared_ptr<gpu::Device> device_;
  bool allowSpecial_ = true;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::list<Special> ready_;  // newest first
  std::deque<VariantKey> wanted_;
  std::vector<VariantKey> failed_;  // not tried again
  double compileSeconds_ = 0.0;
  std::jthread worker_;  // last: joins before the rest dies
};

}  // namespace steradian
