// SPDX-License-Identifier: MIT
// Pipelines for a window, which must not stand still while one is compiled.
#pragma once
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

#include "renderer/variants.hpp"

namespace steradian {

/// Asks Variants on a thread of its own where that would block.
class PatientVariants {
 public:
  /// Both are used until the end.
  PatientVariants(const gpu::Device& device, Variants& variants) : device_(device), variants_(variants) {}

  /// What runs at once, or nothing yet: ask again. Blocks only while there is nothing at all. One thread.
  /// Throws Error when what is needed cannot be compiled.
  std::optional<Variants::Choice> choose(const VariantKey& needed);
  /// Blocks until there is something to choose. Any thread. Throws Error.
  void prepare(const VariantKey& needed);

 private:
  enum class State { empty, wanted, ready };
  State stateOf(const VariantKey& needed);
  void compileAside(const VariantKey& needed);
  bool firstRun(const gpu::ComputePass* pass);

  const gpu::Device& device_;
  Variants& variants_;
  std::mutex mutex_;               // guards what follows
  std::vector<VariantKey> ready_;  // Variants answers at once, with a pass that ran before
  std::set<const gpu::ComputePass*> ran_;
  std::exception_ptr failure_;
  bool compiling_ = false;
  std::jthread compiler_;  // last: ends before the rest dies
};

}  // namespace steradian
