// SPDX-License-Identifier: MIT
#include "renderer/patient_variants.hpp"

#include <algorithm>
#include <utility>

#include "renderer/shader_code.hpp"
#include "renderer/specialize.hpp"

namespace steradian {
namespace {

using namespace gpu;

void dispatchEmpty(const Device& device, const ComputePass& pass) {
  const Bindings bindings(device, {}, {});
  device.run(QueueKind::compute, [&](const auto& cmd) { pass.dispatch(cmd, bindings, TraceParams{}, 1, 1); });
}

/// A CPU driver makes machine code at the first dispatch, on its only queue. When others use that, a second
/// device does it first: through the driver's disk cache the window's device then only loads it.
void runOnce(const Device& device, const VariantKey& key, const ComputePass& pass, bool alone) {
  if (device.description().type != "CPU") return;
  if (!alone) {
    const auto scratch = openDevice({.device = std::to_string(device.description().index)});
    const std::vector<Specialization> constants = constantsOf(*scratch, key);
    const std::vector<std::uint32_t> code = specialized(pathTraceSpirv(), constants);
    if (code.empty()) return;
    dispatchEmpty(*scratch, ComputePass(*scratch, code, {}, "path_trace"));
  }
  dispatchEmpty(device, pass);
}

}  // namespace

PatientVariants::State PatientVariants::stateOf(const VariantKey& needed) {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  if (std::ranges::find(ready_, needed) != ready_.end()) return State::ready;
  return ready_.empty() && !compiling_ ? State::empty : State::wanted;
}

bool PatientVariants::firstRun(const ComputePass* pass) {
  const std::lock_guard lock(mutex_);
  return ran_.insert(pass).second;
}

void PatientVariants::prepare(const VariantKey& needed) {
  const State state = stateOf(needed);
  if (state == State::ready) return;
  const Variants::Choice choice = variants_.choose(needed);
  // Special ones ran where they were compiled.
  if (choice.key == genericFor(choice.key) && firstRun(choice.pass))
    runOnce(device_, choice.key, *choice.pass, state == State::empty);
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
