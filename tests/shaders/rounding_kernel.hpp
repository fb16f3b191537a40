// SPDX-License-Identifier: MIT
// rounding.glsl as C++, in any precision.
#pragma once
#include "renderer/reference/glsl_builtins.hpp"

namespace steradian::reference {

template <class Real>
class RoundingKernel : public GlslBuiltins<Real> {
 public:
  using typename GlslBuiltins<Real>::vec2;
  using typename GlslBuiltins<Real>::vec3;
  using typename GlslBuiltins<Real>::vec4;
  using typename GlslBuiltins<Real>::uvec3;
  using typename GlslBuiltins<Real>::uint;
  RoundingKernel() : GlslBuiltins<Real>(Kinds{}) {}

  // clang-format off
#define float Real
#include "generated/reference/rounding.glsl"
#undef float
  // clang-format on
};

}  // namespace steradian::reference
