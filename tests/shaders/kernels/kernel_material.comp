#version 460
// SPDX-License-Identifier: MIT
// material.glsl: rows of materials as lobes, sampled and evaluated.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "material.glsl"

// (wo, primitive) (u v w, flags) or (wi, flags); flags: 1 = inside, 2 = thin.
void main() {
  uint at = invocation();
  vec4 a = questions[2u * at];
  vec4 b = questions[2u * at + 1u];
  uint primitive = uint(a.w);
  uint flags = uint(b.w);
  Lobes lobes = lobesAt(fetchMaterial(primitive), primitive, a.z, (flags & 1u) != 0u, (flags & 2u) != 0u);
  if (kOperation == 0u) {
    BsdfSample s = sampleBsdf(lobes, a.xyz, b.x, b.y, b.z, lobeKinds());
    answers[2u * at] = vec4(s.wi, s.pdf);
    answers[2u * at + 1u] = vec4(s.weight, evalBsdf(lobes, a.xyz, s.wi, lobeKinds()).pdf);
  } else {
    BsdfValue value = evalBsdf(lobes, a.xyz, b.xyz, lobeKinds());
    answers[at] = vec4(value.fCos, value.pdf);
  }
}
