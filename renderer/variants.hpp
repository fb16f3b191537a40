// SPDX-License-Identifier: MIT
// Model only what a scene needs: the generic tracer is always ready, special ones are compiled on a worker
// thread and picked up between dispatches. All variants give the same samples.
#pragma once
#include <condition_variable>
#include <deque>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "renderer/gpu/pass.hpp"
#include "renderer/gpu_scene.hpp"

namespace steradian {

/// What a special variant was compiled for.
struct VariantKey {
  std::uint32_t features = 0;
  std::uint32_t fixedSpheres = 0, fixedPlanes = 0, fixedLights = 0;  // 0 = counted at run time
  bool ablation = false;                                             // obeys the flags of measurements
  bool operator==(const VariantKey&) const = default;
  /// Compiled for at least what `needed` asks.
  bool covers(const VariantKey& needed) const;
};

/// `lightSamples`: at each vertex, after the loop budget.
VariantKey variantFor(const GpuScene& scene, std::uint32_t lightSamples);
VariantInfo describeVariant(const std::optional<VariantKey>& key);

class Variants {
 public:
  /// Compiles the generic variant.
  explicit Variants(std::shared_ptr<gpu::Device> device);
  ~Variants();

  /// The best pass that is ready: exact, else a wider one, else the generic; asks the worker for the exact
  /// one.
  struct Choice {
    const gpu::ComputePass* pass;
    std::optional<VariantKey> key;  // nothing = generic
  };
  Choice choose(const VariantKey& needed);
  /// Compile `needed` now unless it is there. Blocks.
  void waitFor(const VariantKey& needed);
  void allowSpecial(bool allow);
  double compileSeconds() const;

 private:
  struct Special {
    VariantKey key;
    std::unique_ptr<gpu::ComputePass> pass;
  };
  const Special* find(const VariantKey& needed) const;
  void work(std::stop_token stop);
  void warmDriverCache(const VariantKey& key);
  void finished(const VariantKey& key, std::unique_ptr<gpu::ComputePass> pass, double seconds);

  std::shared_ptr<gpu::Device> device_;
  std::unique_ptr<gpu::ComputePass> generic_;
  bool allowSpecial_ = true;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::list<Special> ready_;  // most recently used first, at most 16
  std::deque<VariantKey> wanted_;
  std::vector<VariantKey> failed_;  // not tried again
  double compileSeconds_ = 0.0;
  std::jthread worker_;  // last: joins before the rest dies
};

}  // namespace steradian
