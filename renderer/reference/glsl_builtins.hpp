// SPDX-License-Identifier: MIT
// What GLSL has and C++ has not, over GLM, for any Real: types, built-in functions, bindings, swizzles.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include <glm/glm.hpp>

#include "shaders/gpu_types.h"

namespace steradian::reference {

using namespace gpu;  // the constants that GLSL shares

// Built-ins on scalars; those on vectors are found by their arguments.
using glm::abs;
using glm::acos;
using glm::atan;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::exp;
using glm::exp2;
using glm::floor;
using glm::fract;
using glm::inversesqrt;
using glm::log;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::mod;
using glm::pow;
using glm::sign;
using glm::sin;
using glm::smoothstep;
using glm::sqrt;
using glm::step;
using glm::tan;

/// Bits are those of the float, whatever Real is: rows carry indices in them.
template <class Real>
std::uint32_t floatBitsToUint(Real x) {
  return std::bit_cast<std::uint32_t>(float(x));
}
inline float uintBitsToFloat(std::uint32_t bits) {
  return std::bit_cast<float>(bits);
}

inline glm::vec2 unpackHalf2x16(std::uint32_t bits) {
  return glm::unpackHalf2x16(bits);
}

inline std::uint32_t bitfieldReverse(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}

/// Swizzles: v.xyz is rewritten as v->*xyz, which binds as tightly as it must.
struct SwizzleXy {};
struct SwizzleXyz {};
inline constexpr SwizzleXy xy;
inline constexpr SwizzleXyz xyz;
template <glm::length_t N, class Real>
glm::vec<2, Real> operator->*(const glm::vec<N, Real>& v, SwizzleXy) {
  return glm::vec<2, Real>(v);
}
template <glm::length_t N, class Real>
glm::vec<3, Real> operator->*(const glm::vec<N, Real>& v, SwizzleXyz) {
  return glm::vec<3, Real>(v);
}

/// What a scene holds, as its special pipeline has it compiled in; all features and none of the others is
/// what fits any scene without glowing meshes and solids.
struct Kinds {
  std::uint32_t features = ~0u;  // FEATURE_*: bit i is specialization constant i, as on the device
  bool shapeHierarchy = false, meshLights = false;
  std::uint32_t solidLights = 0;  // bit i: CONSTANT_SOLID_LIGHTS + i
};

/// Types and bindings of one build; `Shaders` adds the functions. Rows stay float, as they are on the device.
template <class Real>
class GlslBuiltins {
 public:
  using vec2 = glm::vec<2, Real>;
  using vec3 = glm::vec<3, Real>;
  using vec4 = glm::vec<4, Real>;
  using mat3 = glm::mat<3, 3, Real>;
  using uvec2 = glm::uvec2;
  using uvec3 = glm::uvec3;
  using ivec3 = glm::ivec3;
  using ivec4 = glm::ivec4;
  using uint = std::uint32_t;
  using samplerBuffer = std::span<const glm::vec4>;
  using isamplerBuffer = std::span<const glm::ivec4>;
  using usamplerBuffer = std::span<const std::uint32_t>;

  /// Push constants, their numbers in this precision.
  struct Params : gpu::TraceParams {
    Real clampRadiance = 0, pixelScale = 0;
    Params() = default;
    explicit Params(const gpu::TraceParams& p)
        : gpu::TraceParams(p), clampRadiance(Real(p.clampRadiance)), pixelScale(Real(p.pixelScale)) {}
  };

  Params params{gpu::TraceParams{}};
  samplerBuffer sceneRows, tableRows, meshRows;
  usamplerBuffer texels;

 protected:
  explicit GlslBuiltins(const Kinds& kinds) : kinds_(kinds) {}

  template <class T>
  T specialized(std::uint32_t id, T generic) const {
    if (id == gpu::CONSTANT_SHAPE_HIERARCHY) return T(kinds_.shapeHierarchy);
    if (id == gpu::CONSTANT_MESH_LIGHTS) return T(kinds_.meshLights);
    if (id >= gpu::CONSTANT_SOLID_LIGHTS && id < gpu::CONSTANT_SOLID_LIGHTS + gpu::SOLID_LIGHT_KINDS)
      return T((kinds_.solidLights >> (id - gpu::CONSTANT_SOLID_LIGHTS)) & 1u);
    return id < gpu::FEATURE_COUNT ? T((kinds_.features >> id) & 1u) : generic;
  }
  /// Beyond the end 0, as a robust device answers.
  static vec4 texelFetch(samplerBuffer rows, int at) {
    return at >= 0 && std::size_t(at) < rows.size() ? vec4(rows[std::size_t(at)]) : vec4(0);
  }
  static glm::ivec4 texelFetch(isamplerBuffer rows, int at) { return rows[std::size_t(at)]; }
  static glm::uvec4 texelFetch(usamplerBuffer words, int at) {
    return {at >= 0 && std::size_t(at) < words.size() ? words[std::size_t(at)] : 0u, 0u, 0u, 1u};
  }

 private:
  Kinds kinds_;
};

}  // namespace steradian::reference
