// SPDX-License-Identifier: MIT
// @id org.steradian.tonemap.khronos_pbr_neutral
// @name Khronos PBR Neutral
// Khronos Group 2024, "Khronos PBR Neutral Tone Mapper" specification: base colours stay as they are below 0.8,
// highlights are compressed and desaturated, the Fresnel offset of 0.04 is taken off.
const float kNeutralStart = 0.8 - 0.04;  // where compression begins
const float kNeutralDesaturation = 0.15;

vec3 tonemap(vec3 sceneLinear) {
  vec3 c = clamp(sceneLinear, 0.0, 65504.0);
  float x = min(c.r, min(c.g, c.b));
  c -= x < 0.08 ? x - 6.25 * x * x : 0.04;
  float peak = max(c.r, max(c.g, c.b));
  if (peak < kNeutralStart) return c;

  float d = 1.0 - kNeutralStart;
  float compressedPeak = 1.0 - d * d / (peak + d - kNeutralStart);
  c *= compressedPeak / peak;
  float towardsWhite = 1.0 - 1.0 / (kNeutralDesaturation * (peak - compressedPeak) + 1.0);
  return mix(c, vec3(compressedPeak), towardsWhite);
}
