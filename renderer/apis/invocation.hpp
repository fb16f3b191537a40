// SPDX-License-Identifier: MIT
// path_trace.comp as C++ in float: one object is one invocation, and main() is the shader's.
#pragma once
#include <atomic>
#include <span>

#include "renderer/reference/glsl_builtins.hpp"

namespace steradian::apis {

using namespace reference;  // GLSL's functions and the constants that it shares

/// Members are rewritten by cmake/GlslAsCpp.cmake. The film is shared by all invocations of a dispatch.
class Invocation : public GlslBuiltins<float> {
 public:
  using Real = float;

  /// `constants`: specialization constants by their id; the rest have their defaults.
  explicit Invocation(std::span<const std::uint32_t> constants)
      : GlslBuiltins<float>(Kinds{}), constants_(constants) {}

  static constexpr glm::uvec3 gl_WorkGroupSize{8, 8, 1};  // as the shader's layout says
  glm::uvec3 gl_NumWorkGroups{0}, gl_WorkGroupID{0}, gl_LocalInvocationID{0}, gl_GlobalInvocationID{0};
  std::span<ivec4> filmLow, filmMiddle, filmHigh;
  isamplerBuffer lowBefore, middleBefore, highBefore;  // the same
  std::span<uint> counters;

 private:
  template <class T>
  T specialized(std::uint32_t id, T generic) const {
    return id < constants_.size() ? T(constants_[id]) : generic;
  }
  static uint atomicAdd(uint& counter, uint value) { return std::atomic_ref<uint>(counter).fetch_add(value); }
  std::span<const std::uint32_t> constants_;  // before the text: its constants are made of them

 public:
  // clang-format off
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "generated/reference/path_trace.comp"
#pragma GCC diagnostic pop
  // clang-format on
};

}  // namespace steradian::apis
