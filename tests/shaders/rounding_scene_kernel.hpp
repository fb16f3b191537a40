// SPDX-License-Identifier: MIT
// rounding_scene.glsl as C++, in any precision.
#pragma once
#include "renderer/reference/device_paths.hpp"
#include "renderer/reference/glsl_builtins.hpp"

namespace steradian::reference {

template <class Real>
class RoundingSceneKernel : public GlslBuiltins<Real> {
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

  /// `traced` must stay alive.
  explicit RoundingSceneKernel(const TracedScene& traced) : GlslBuiltins<Real>(Kinds{}) {
    params = typename GlslBuiltins<Real>::Params(traced.scene.params);
    sceneRows = traced.scene.rows;
    tableRows = traced.tables;
    meshRows = traced.meshes;
    texels = traced.texels;
  }

  // clang-format off
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#define float Real
#include "generated/reference/rounding_scene.glsl"
#undef float
#pragma GCC diagnostic pop
  // clang-format on

 private:
  using GlslBuiltins<Real>::specialized;
  using GlslBuiltins<Real>::texelFetch;
};

}  // namespace steradian::reference
