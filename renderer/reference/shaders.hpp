// SPDX-License-Identifier: MIT
// The production GLSL as a class: `Shaders<double>` computes what the device computes, without its rounding.
// The same formulas with the same bugs: a judge of rounding, never of physics.
#pragma once
#include <vector>

#include "renderer/reference/glsl_builtins.hpp"

namespace steradian::reference {

/// Members are the functions, structs and constants of shaders/*.glsl, rewritten by cmake/GlslAsCpp.cmake.
template <class Real>
class Shaders : public GlslBuiltins<Real> {
 public:
  using typename GlslBuiltins<Real>::vec2;
  using typename GlslBuiltins<Real>::vec3;
  using typename GlslBuiltins<Real>::vec4;
  using typename GlslBuiltins<Real>::mat3;
  using typename GlslBuiltins<Real>::uvec2;
  using typename GlslBuiltins<Real>::uvec3;
  using typename GlslBuiltins<Real>::uint;
  using GlslBuiltins<Real>::params;
  using GlslBuiltins<Real>::sceneRows;
  using GlslBuiltins<Real>::meshRows;
  using GlslBuiltins<Real>::tableRows;
  using GlslBuiltins<Real>::texels;

  /// `kinds`: those of the variant to be followed.
  explicit Shaders(const Kinds& kinds = {}) : GlslBuiltins<Real>(kinds) {}

  std::vector<vec4> recordRows;  // what path.glsl writes

  // clang-format off
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#define float Real
#include "generated/reference/path_record.glsl"
#undef float
#pragma GCC diagnostic pop
  // clang-format on

 private:
  using GlslBuiltins<Real>::specialized;
  using GlslBuiltins<Real>::texelFetch;
};

}  // namespace steradian::reference
