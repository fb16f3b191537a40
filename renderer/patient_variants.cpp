// SPDX-License-Identifier: MIT
#include "renderer/patient_variants.hpp"

#include <algorithm>
#include <utility>

namespace steradian {

PatientVariants::State PatientVariants::stateOf(const VariantKey& needed) {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  if (std::ranges::find(ready_, needed) != ready_.end()) return State::ready;
  return ready_.empty() && !compiling_ ? State::empty : State::wanted;
}

bool PatientVariants::firstRun(const gpu::ComputePass* pass) {
  const std::lock_guard lock(mutex_);
  return ran_.insert(pass).second;
}

void PatientVariants::prepare(const VariantKey& needed) {
  const State state = stateOf(needed);
  if (state == State::ready) return;
  const Variants::Choice choice = variants_.choose(needed);
  // Special ones ran where they were compiled. Where nothing else uses the queue, nothing is stalled.
  const bool onCpu = device_.description().type == "CPU";
  if (onCpu && choice.key == genericFor(choice.key) && firstRun(choice.pass)) {
    if (state != State::empty) warmDriverCache(device_, choice.key);
    dispatchNothing(device_, *choice.pass);
  }
  const std::lock_guard lock(mutex_);
  ready_.push_back(needed);
}

void PatientVariants::compileAside(const VariantKey& needed) {
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(compiling_, true)) return;
  }
  compiler_ = std::jthread([this, needed] {
    std::exception_ptr failure;
    try {
      prepare(needed);
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    compiling_ = false;
    failure_ = failure;
  });
}

std::optional<Variants::Choice> PatientVariants::choose(const VariantKey& needed) {
  const State state = stateOf(needed);
  if (state == State::wanted) {
    compileAside(needed);
    return std::nullopt;
  }
  const Variants::Choice choice = variants_.choose(needed);
  if (state == State::ready) return choice;
  const std::lock_guard lock(mutex_);
  ran_.insert(choice.pass);  // in a moment, and nothing else waits for the queue
  ready_.push_back(needed);
  return choice;
}

}  // namespace steradian
